// TetGen's mesh for handles and tunnels is computed concurrently: the result is the same as without
// concurrency; TetGen ends with the object; an abort and TetGen's errors reach the caller that
// takes the mesh.

#include "ChokingLoops/GeneratorCompletion.h"
#include "ChokingSurfaces.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

bool HasChild()
{
  siginfo_t ended{};
  return waitid(P_ALL, 0, &ended, WEXITED | WNOHANG | WNOWAIT) == 0 || errno != ECHILD;
}

/// Enough triangles for TetGen to work for a second or more.
TriangleMesh LargeTorus()
{
  return Torus(1.0, 0.3, 600, 200);
}

TEST(ConformingMesh, IsReadyWhenWaitedFor)
{
  const TriangleMesh torus = Torus(1.0, 0.3, 30, 12);
  TetrahedralParameters parameters;
  parameters.Side = MeshedSide::Both;
  parameters.TetGen.RadiusEdgeRatio = 0.0;
  const TetrahedralMesh expected = MeshTetrahedra(torus, parameters);
  ConformingMesh mesh(torus);
  const TetrahedralMesh made = mesh.Take({});
  EXPECT_EQ(made.Points, expected.Points);
  EXPECT_EQ(made.Tetrahedra, expected.Tetrahedra);
  EXPECT_EQ(made.Regions, expected.Regions);
}

TEST(ConformingMesh, TetGenStopsWithIt)
{
  const TriangleMesh torus = LargeTorus();
  {
    ConformingMesh mesh(torus);
    EXPECT_THROW(mesh.Take([](double) { return !HasChild(); }), Cancelled);
    EXPECT_TRUE(HasChild());
  }
  EXPECT_FALSE(HasChild());
}

TEST(ConformingMesh, ThrowsTetGensMessage)
{
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  const TriangleMesh torus = Torus(1.0, 0.3, 30, 12);
  ConformingMesh mesh(torus);
  EXPECT_THROW(mesh.Take({}), std::exception);
  setenv("PATH", path.c_str(), 1);
}

}
