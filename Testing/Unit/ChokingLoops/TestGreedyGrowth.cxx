// The membrane that grows greedily from a choke triangle: its path and cost in one ring, and
// compared with the minimum cut and the automatic membrane on shapes whose necks are known.

#include "BeadShapes.h"
#include "ChokingLoops/GreedyMembrane.h"
#include "ChokingSurfaces.h"
#include "Core/Index.h"
#include "Persistence/LowerStarFiltration.h"
#include "Tetrahedra/TetrahedralMesher.h"
#include "vtkChokingLoops.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

// An octahedron around v: f = (v, a, b) between c above and d below, which enter last; the path
// from a to b passes p or q.
constexpr SimplexId V = 0, A = 1, B = 2, C = 3, D = 4, P = 5, Q = 6;

TriangleMesh Hull()
{
  TriangleMesh hull;
  hull.Points = { { 0, 0, 0 }, { 0.5, -0.8, 0 }, { 0.5, 0.8, 0 }, { 0, 0, 1 }, { 0, 0, -1 },
    { -1.4, 0, 0.3 }, { -0.8, 0, -0.2 } };
  hull.Triangles = { { B, P, C }, { P, A, C }, { Q, B, D }, { A, Q, D }, { P, Q, A }, { B, Q, P },
    { A, B, C }, { B, A, D } };
  return hull;
}

std::optional<GreedyPatches> GrowthInOneRing(double valueOfP, double valueOfQ)
{
  TriangleMesh hull = Hull();
  TetrahedralMesh mesh;
  mesh.Points = hull.Points;
  for (const Triangle& t : hull.Triangles)
  {
    mesh.Tetrahedra.push_back({ t[0], t[1], t[2], V });
  }
  std::vector<double> values(7, 0.0);
  values[V] = 1.5;
  values[C] = values[D] = 3.0;
  values[P] = valueOfP;
  values[Q] = valueOfQ;
  const CellFiltration f = LowerStarFiltration(mesh, values, hull);
  const FiltrationPairs pairs(f);
  const SurfaceAdjacency adjacency(hull);
  const SurfaceHomology homology(adjacency);
  const SurfaceInComplex embedding(adjacency, f);
  const FeatureContext context{ f, pairs, homology, embedding, adjacency, {}, {}, values };
  ShapeFeature feature;
  for (const TriangleId t : f.Triangles())
  {
    feature.Choke = f.TrianglePoints(t) == std::array<SimplexId, 3>{ V, A, B } ? t : feature.Choke;
  }
  std::optional<GreedyPatches> found = GrowGreedily(context, feature);
  for (const TriangleId t : found ? found->Triangles : TriangleChain{})
  {
    const auto corners = f.TrianglePoints(t);
    EXPECT_TRUE(t == feature.Choke || corners[1] == P || corners[2] == P || corners[2] == Q);
    EXPECT_TRUE(f.RankOfTriangle[t] <= f.RankOfTriangle[feature.Choke]);
  }
  return found;
}

double Way(SimplexId over)
{
  const TriangleMesh hull = Hull();
  return Distance(hull.Points[A], hull.Points[At(over)]) +
    Distance(hull.Points[At(over)], hull.Points[B]);
}

// f is the last triangle of its value, since the cells beside it have the last numbers.
TEST(GreedyGrowth, PathIsTheCheapestByLengthAndDistance)
{
  const auto byLength = GrowthInOneRing(0.0, 0.0);
  ASSERT_TRUE(byLength);
  EXPECT_EQ(byLength->Triangles.size(), 3U);
  EXPECT_EQ(byLength->Steps, 1U);
  EXPECT_NEAR(byLength->Cost, 0.5 * Way(Q), 1e-12); // q is nearer than p
  EXPECT_LT(Way(Q), Way(P));
  // The path over p is longer by 0.9, so q may be deeper by the same amount.
  const double detour = Way(P) - Way(Q);
  EXPECT_NEAR(GrowthInOneRing(0.0, 0.99 * detour)->Cost, 0.5 * (Way(Q) + 0.99 * detour), 1e-12);
  EXPECT_NEAR(GrowthInOneRing(0.0, 1.01 * detour)->Cost, 0.5 * Way(P), 1e-12);
}

TEST(GreedyGrowth, TakesOnlyEarlierTriangles)
{
  EXPECT_NEAR(GrowthInOneRing(0.0, 2.0)->Cost, 0.5 * Way(P), 1e-12);
  EXPECT_NEAR(GrowthInOneRing(2.0, 0.0)->Cost, 0.5 * Way(Q), 1e-12);
  EXPECT_FALSE(GrowthInOneRing(2.0, 2.0));
}

/// The filter on a surface and a mesh of its inside; the analysis is computed once.
class Membranes
{
public:
  explicit Membranes(const TriangleMesh& mesh)
  {
    vtkNew<vtkPolyData> surface;
    SetMesh(mesh, surface);
    TetrahedralParameters parameters;
    parameters.TetGen.MaximumVolume = 5e-4;
    const TetrahedralMesh cells = MeshTetrahedra(mesh, parameters);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Point3& p : cells.Points)
    {
      points->InsertNextPoint(p.data());
    }
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    for (const Tetrahedron& t : cells.Tetrahedra)
    {
      grid->InsertNextCell(VTK_TETRA, 4, t.data());
    }
    this->Filter->SetInputData(0, surface);
    this->Filter->SetInputData(1, grid);
    this->Filter->SetSide(vtkChokingLoops::Inside);
    this->Filter->SetFiltration(vtkChokingLoops::TetrahedralMesh);
    this->Filter->AddObserver(vtkCommand::WarningEvent, this->Observer);
  }

  struct DrawnLoops
  {
    double Longest = 0.0; ///< of its loops
    double Radius = 0.0;
    double Area = 0.0;
    double Cost = 0.0;
    int Method = 0;
  };

  /// By feature.
  std::map<int, DrawnLoops> By(int method, int shortening)
  {
    this->Filter->SetMembraneMethod(method);
    this->Filter->SetShortening(shortening);
    this->Filter->Update();
    std::map<int, DrawnLoops> found;
    vtkPolyData* loops = this->Filter->GetOutput();
    for (vtkIdType i = 0; i < loops->GetNumberOfCells(); ++i)
    {
      const auto of = [&](const char* name)
      { return loops->GetCellData()->GetArray(name)->GetTuple1(i); };
      DrawnLoops& m = found[static_cast<int>(of("FeatureId"))];
      m.Longest = std::max(m.Longest, of("Length"));
      m.Radius = of("Radius");
    }
    vtkCellData* triangles =
      vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1))->GetCellData();
    for (vtkIdType i = 0; i < triangles->GetNumberOfTuples(); ++i)
    {
      const auto of = [&](const char* name)
      { return triangles->HasArray(name) ? triangles->GetArray(name)->GetTuple1(i) : 0.0; };
      DrawnLoops& m = found[static_cast<int>(of("FeatureId"))];
      m.Area = of("Area");
      m.Method = static_cast<int>(of("Method"));
      m.Cost = of("GrowthCost");
    }
    EXPECT_EQ(triangles->HasArray("Method") != 0, method != vtkChokingLoops::Automatic);
    EXPECT_EQ(triangles->HasArray("GrowthCost") != 0, method == vtkChokingLoops::Greedy);
    return found;
  }

  vtkNew<vtkChokingLoops> Filter;
  vtkNew<vtkTest::ErrorObserver> Observer;
};

// A ring of beads: one neck is a handle, the others separate beads; each is a disk of known radius.
TEST(GreedyGrowth, AgreesWithTheMinimumCutAtKnownNecks)
{
  constexpr double neck = 0.4;
  Membranes membranes(Necklace(3, neck).Surface(0.14));
  const auto automatic = membranes.By(vtkChokingLoops::Automatic, vtkChokingLoops::None);
  const auto cut = membranes.By(vtkChokingLoops::MinimumCut, vtkChokingLoops::None);
  const auto greedy = membranes.By(vtkChokingLoops::Greedy, vtkChokingLoops::None);
  const auto tight = membranes.By(vtkChokingLoops::Greedy, vtkChokingLoops::Geodesic);
  ASSERT_EQ(automatic.size(), 3U);
  ASSERT_EQ(cut.size(), 3U);
  ASSERT_EQ(greedy.size(), 3U);
  const double disk = M_PI * neck * neck;
  int compared = 0;
  for (const auto& [feature, m] : greedy)
  {
    EXPECT_EQ(m.Method, vtkChokingLoops::Greedy) << feature;
    EXPECT_GT(m.Area, 0.9 * disk); // the mesh's edges cut corners of the neck's polygon
    EXPECT_LT(m.Area, 1.6 * disk);
    EXPECT_GT(m.Cost, 0.5 * m.Longest) << "each edge of the loop is part of a path or of f";
    EXPECT_NEAR(tight.at(feature).Longest, 2.0 * M_PI * neck, 0.02 * 2.0 * M_PI * neck);
    if (cut.at(feature).Method == vtkChokingLoops::MinimumCut)
    {
      EXPECT_LE(cut.at(feature).Area, m.Area) << "the cut is the least";
      EXPECT_GT(cut.at(feature).Area, 0.9 * disk);
      ++compared;
    }
  }
  EXPECT_GE(compared, 2);
}

// The Delaunay filtration has no points off the surface.
TEST(GreedyGrowth, NeedsAMeshWithPointsOffTheSurface)
{
  Membranes membranes(Necklace(3, 0.4).Surface(0.2));
  membranes.Filter->SetFiltration(vtkChokingLoops::Delaunay);
  const auto automatic = membranes.By(vtkChokingLoops::Automatic, vtkChokingLoops::Geodesic);
  EXPECT_FALSE(membranes.Observer->GetWarning());
  const auto greedy = membranes.By(vtkChokingLoops::Greedy, vtkChokingLoops::Geodesic);
  EXPECT_NE(membranes.Observer->GetWarningMessage().find("Greedy"), std::string::npos);
  ASSERT_EQ(greedy.size(), automatic.size());
  ASSERT_FALSE(greedy.empty());
  for (const auto& [feature, m] : greedy)
  {
    EXPECT_EQ(m.Method, vtkChokingLoops::Automatic);
    EXPECT_EQ(m.Area, automatic.at(feature).Area);
    EXPECT_EQ(m.Cost, 0.0);
  }
  const auto cut = membranes.By(vtkChokingLoops::MinimumCut, vtkChokingLoops::None);
  EXPECT_TRUE(std::any_of(cut.begin(), cut.end(),
    [](const auto& entry) { return entry.second.Method == vtkChokingLoops::MinimumCut; }));
}

}
