// Persistence of a function on a tetrahedral mesh by TTK's Discrete Morse Sandwich on TTK's
// explicit triangulation: ttk_mesh_persistence IN.tetrahedra OUT.diagram OUT.seconds [THREADS] The
// mesh as TetrahedraFiles.h says, the pairs in DIPHA's format (DiphaFiles.h); the last file gets
// two numbers, the CPU and the wall seconds of preconditioning, gradient and pairing, files not
// among them. One thread by default.
//
// Not part of Isthmus: it needs TTK's base layer.

#include "TTKPairs.h"
#include "TetrahedraFiles.h"

#include <ExplicitTriangulation.h>

#include <chrono>
#include <ctime>
#include <exception>
#include <iostream>

namespace
{

isthmus::testing::DiphaPairs ComputePairs(
  const isthmus::testing::ValuedTetrahedra& mesh, int threads)
{
  static_assert(sizeof(ttk::LongSimplexId) == sizeof(std::int64_t));
  std::vector<ttk::LongSimplexId> corners;
  std::vector<ttk::LongSimplexId> begins{ 0 };
  for (const auto& t : mesh.Tetrahedra)
  {
    corners.insert(corners.end(), t.begin(), t.end());
    begins.push_back(static_cast<ttk::LongSimplexId>(corners.size()));
  }
  ttk::ExplicitTriangulation triangulation;
  triangulation.setDebugLevel(0);
  triangulation.setThreadNumber(threads);
  triangulation.setInputPoints(
    static_cast<ttk::SimplexId>(mesh.Points.size()), mesh.Points.data(), true);
  triangulation.setInputCells(
    static_cast<ttk::SimplexId>(mesh.Tetrahedra.size()), corners.data(), begins.data());
  return isthmus::testing::TTKPairs(triangulation, mesh.Values, threads);
}

}

int main(int count, char** words)
{
  try
  {
    if (count != 4 && count != 5)
    {
      throw std::runtime_error(
        "usage: ttk_mesh_persistence IN.tetrahedra OUT.diagram OUT.seconds [THREADS]");
    }
    const auto mesh = isthmus::testing::ReadTetrahedra(words[1]);
    const std::clock_t cpu = std::clock();
    const auto started = std::chrono::steady_clock::now();
    const auto pairs = ComputePairs(mesh, count == 5 ? std::stoi(words[4]) : 1);
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - started;
    std::ofstream(words[3]) << static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC << ' '
                            << wall.count() << '\n';
    isthmus::testing::WriteDiphaPairs(words[2], pairs);
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
