// The thesis' filtration, a function on a tetrahedral mesh: pairs against a plain reduction of the
// boundary matrix, its two-tetrahedra example, and the four Morse functions through the filter.

#include "BlockMeshes.h"
#include "ChokingSurfaces.h"
#include "LoopChecks.h"
#include "Persistence/LowerStarFiltration.h"
#include "Persistence/MorseValues.h"
#include "SurfaceFiles.h"
#include "Tetrahedra/TetrahedralMesher.h"
#include "TopologyFilterRun.h"

#include <vtkCellData.h>
#include <vtkChokingLoops.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Thesis, 6.2.1: tetrahedra 0123 and 1234, in the order of its list.
TEST(LowerStarFiltration, TwoTetrahedraOfTheThesis)
{
  const std::vector<std::string> order{ "0", "1", "01", "2", "02", "12", "012", "3", "03", "13",
    "013", "23", "023", "4", "14", "24", "124", "34", "134", "234", "123", "0123", "1234" };
  const auto time = [&order](const auto& corners)
  {
    std::string name;
    for (const SimplexId p : corners)
    {
      name += static_cast<char>('0' + p);
    }
    std::sort(name.begin(), name.end());
    return static_cast<double>(std::find(order.begin(), order.end(), name) - order.begin());
  };
  CellFiltration f;
  f.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 1 } };
  f.Tetrahedra = { { 0, 1, 2, 3 }, { 4, 1, 2, 3 } };
  constexpr TetrahedronId none = TetrahedronId::None();
  f.Neighbours = { { TetrahedronId(1), none, none, none }, { TetrahedronId(0), none, none, none } };
  f.Connect();
  for (const auto& t : f.Tetrahedra)
  {
    f.TetrahedronValue.push_back(time(t));
  }
  for (const TriangleId t : f.Triangles())
  {
    f.TriangleValue.push_back(time(f.TrianglePoints(t)));
  }
  for (const auto& e : f.Edges)
  {
    f.EdgeValue.push_back(time(e));
  }
  f.Order();
  const FiltrationPairs pairs(f);
  std::map<std::string, std::string> found;
  const auto name = [&order](double value) { return order[static_cast<std::size_t>(value)]; };
  for (const EdgeId e : f.Edges.Keys())
  {
    const TriangleId filler = pairs.LoopFilled(e);
    if (filler.Exists())
    {
      found[name(f.EdgeValue[e])] = name(f.TriangleValue[filler]);
    }
  }
  for (const TriangleId t : f.Triangles())
  {
    const TetrahedronId filler = pairs.VoidFilled(t);
    if (filler.Exists())
    {
      const double death = f.TetrahedronValue[filler];
      found[name(f.TriangleValue[t])] = name(death);
      // Only the closed membrane 234 is not filled immediately.
      EXPECT_EQ(death - f.TriangleValue[t], name(death) == "1234" ? 3.0 : 1.0);
    }
  }
  const std::map<std::string, std::string> published{ { "12", "012" }, { "13", "013" },
    { "23", "023" }, { "24", "124" }, { "34", "134" }, { "123", "0123" }, { "234", "1234" } };
  EXPECT_EQ(found, published);
}

/// Random values, 0 on the surface; every third one equal to another, so that ties occur.
std::vector<double> RandomValues(const Blocks& blocks, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.1, 1.0);
  std::set<Point3> surface;
  for (const Triangle& t : blocks.Surface.Triangles)
  {
    for (const std::int64_t p : t)
    {
      surface.insert(blocks.Surface.Points[static_cast<std::size_t>(p)]);
    }
  }
  std::vector<double> values;
  for (const Point3& p : blocks.Mesh.Points)
  {
    const double drawn = uniform(random);
    values.push_back(surface.count(p) > 0 ? 0.0 : values.size() % 3 == 0 ? 0.5 : drawn);
  }
  return values;
}

struct BlockCase
{
  const char* Name;
  std::array<std::int64_t, 3> Size;
  std::function<bool(std::int64_t, std::int64_t, std::int64_t)> Solid;
  std::size_t Genus;
};

/// A ball, a ring two cubes thick and a ring one cube thick (all of whose points lie on it), and
/// two balls with a neck.
std::vector<BlockCase> BlockCases()
{
  const auto within = [](std::int64_t v, std::int64_t low, std::int64_t high)
  { return v >= low && v < high; };
  return { { "ball", { 5, 5, 5 },
             [within](auto i, auto j, auto k)
             { return within(i, 1, 4) && within(j, 1, 4) && within(k, 1, 4); },
             0 },
    { "ring", { 8, 8, 4 },
      [within](auto i, auto j, auto k)
      {
        return within(i, 1, 7) && within(j, 1, 7) && within(k, 1, 3) &&
          !(within(i, 3, 5) && within(j, 3, 5));
      },
      1 },
    { "thin ring", { 5, 5, 3 },
      [within](auto i, auto j, auto k)
      { return within(i, 1, 4) && within(j, 1, 4) && k == 1 && !(i == 2 && j == 2); },
      1 },
    { "neck", { 9, 5, 5 },
      [within](auto i, auto j, auto k)
      {
        return (within(i, 1, 4) || within(i, 5, 8) || (i == 4 && j == 2 && k == 2)) &&
          within(j, 1, 4) && within(k, 1, 4);
      },
      0 } };
}

TEST(LowerStarFiltration, PairsMatchThePlainReduction)
{
  for (const BlockCase& c : BlockCases())
  {
    for (const bool withOutside : { true, false })
    {
      const Blocks blocks(c.Size, c.Solid, withOutside);
      for (unsigned seed = 1; seed <= 3; ++seed)
      {
        const std::vector<double> values = RandomValues(blocks, seed);
        ChokingLoops loops(blocks.Surface, blocks.Mesh, values, std::nullopt);
        const std::multiset<Pair> expected = PairsByReduction(blocks, values);
        std::multiset<Pair> found;
        for (const ShapeFeature& f : loops.Diagram().Features)
        {
          found.emplace(f.Dimension, f.PairBirth, f.PairDeath);
        }
        ASSERT_EQ(found.size(), expected.size()) << c.Name << ", seed " << seed;
        for (auto a = found.begin(), b = expected.begin(); a != found.end(); ++a, ++b)
        {
          EXPECT_EQ(std::get<0>(*a), std::get<0>(*b)) << c.Name;
          EXPECT_NEAR(std::get<1>(*a), std::get<1>(*b), 1e-12) << c.Name;
          EXPECT_NEAR(std::get<2>(*a), std::get<2>(*b), 1e-12) << c.Name;
        }
        const auto [handles, tunnels] = Generators(loops);
        EXPECT_EQ(handles.size(), c.Genus) << c.Name;
        EXPECT_EQ(tunnels.size(), withOutside ? c.Genus : 0) << c.Name;
        for (const auto& kind : { handles, tunnels })
        {
          std::for_each(kind.begin(), kind.end(), [&](std::size_t i) { ExpectSound(loops, i); });
        }
        if (withOutside)
        {
          ExpectGenerators(loops, c.Genus);
        }
      }
    }
  }
}

void SetTetrahedra(const TetrahedralMesh& mesh, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& p : mesh.Points)
  {
    points->InsertNextPoint(p.data());
  }
  grid->SetPoints(points);
  for (const Tetrahedron& t : mesh.Tetrahedra)
  {
    const std::array<vtkIdType, 4> ids{ t[0], t[1], t[2], t[3] };
    grid->InsertNextCell(VTK_TETRA, 4, ids.data());
  }
}

/// The filter on a mesh of both sides of a torus that has points within.
class MorseFunctions : public ::testing::Test
{
protected:
  void SetUp() override
  {
    TetrahedralParameters parameters;
    parameters.Side = MeshedSide::Both;
    parameters.BoxMargin = 0.1;
    parameters.TetGen.MaximumVolume = 2e-4;
    this->Ring = Torus(1.0, 0.3, 48, 24);
    this->Mesh = MeshTetrahedra(this->Ring, parameters);
    SetMesh(this->Ring, this->Surface);
    SetTetrahedra(this->Mesh, this->Grid);
    this->Exact = SurfaceDistances(this->Ring, this->Mesh.Points);
    this->AddArray("depth", 1.0);
  }

  void AddArray(const char* name, double factor)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const double d : this->Exact)
    {
      array->InsertNextValue(factor * d);
    }
    this->Grid->GetPointData()->AddArray(array);
  }

  /// A handle or tunnel.
  struct Found
  {
    double Radius = -1.0;
    double Uncertainty = 0.0;
    bool Trusted = false;
  };

  /// The only handle and the only tunnel of a run that issued no message.
  static std::array<Found, 2> HandleAndTunnel(TopologyFilterRun<vtkChokingLoops>& run)
  {
    EXPECT_EQ(run.Messages(), "");
    vtkCellData* loops = run.Surface(0)->GetCellData();
    EXPECT_GE(run.Surface(0)->GetNumberOfCells(), 2);
    std::array<Found, 2> found;
    for (vtkIdType i = 0; i < run.Surface(0)->GetNumberOfCells(); ++i)
    {
      const auto of = [&](const char* name) { return loops->GetArray(name)->GetTuple1(i); };
      const auto kind = static_cast<std::size_t>(of("Kind"));
      if (kind < 2)
      {
        EXPECT_EQ(found[kind].Radius, -1.0) << "two of a kind";
        found[kind] = { of("Radius"), of("Uncertainty"), of("Trusted") == 1.0 };
      }
    }
    return found;
  }

  std::array<Found, 2> Measure(int function, const char* array = "depth")
  {
    TopologyFilterRun<vtkChokingLoops> run(this->Surface,
      [&](vtkChokingLoops* filter)
      {
        filter->SetInputData(1, this->Grid);
        filter->SetFiltration(vtkChokingLoops::TetrahedralMesh);
        filter->SetMorseFunction(function);
        filter->SetMorseArrayName(array);
        filter->SetMinimumPersistence(30.0);
      });
    return HandleAndTunnel(run);
  }

  std::array<double, 2> Radii(int function, const char* array = "depth")
  {
    const std::array<Found, 2> found = this->Measure(function, array);
    return { found[0].Radius, found[1].Radius };
  }

  /// Values of the polyhedron: the cross-section is a polygon of 24 sides, and the hole one of 48.
  const std::array<double, 2> Polyhedron{ 0.3 * std::cos(M_PI / 24.0),
    0.7 * std::cos(M_PI / 48.0) };

  TriangleMesh Ring;
  TetrahedralMesh Mesh;
  std::vector<double> Exact;
  vtkNew<vtkPolyData> Surface;
  vtkNew<vtkUnstructuredGrid> Grid;
};

// Persistence is stable: two functions that differ by at most s give radii that do.
TEST_F(MorseFunctions, AgreeWhereTheyAreTheSameFunction)
{
  const std::array<Found, 2> found = this->Measure(vtkChokingLoops::ClosestPoint);
  const std::array<double, 2> exact{ found[0].Radius, found[1].Radius };
  EXPECT_EQ(this->Radii(vtkChokingLoops::PointArray), exact);
  for (std::size_t k = 0; k < 2; ++k)
  {
    EXPECT_TRUE(found[k].Trusted);
    EXPECT_NEAR(exact[k], this->Polyhedron[k], found[k].Uncertainty);
    EXPECT_LT(found[k].Uncertainty, 0.15);
  }

  this->AddArray("double depth", 2.0);
  const std::array<double, 2> twice = this->Radii(vtkChokingLoops::PointArray, "double depth");

  std::vector<std::int64_t> sources;
  for (std::size_t i = 0; i < this->Exact.size(); ++i)
  {
    if (this->Exact[i] < 1e-12)
    {
      sources.push_back(static_cast<std::int64_t>(i));
    }
  }
  const std::vector<double> paths = EdgeDistances(this->Mesh, sources);
  double excess = 0.0;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    EXPECT_GE(paths[i], this->Exact[i] - 1e-12);
    excess = std::max(excess, paths[i] - this->Exact[i]);
  }
  Bounds3 box{ this->Mesh.Points[0], this->Mesh.Points[0] };
  std::for_each(
    this->Mesh.Points.begin(), this->Mesh.Points.end(), [&box](const Point3& p) { box.Add(p); });
  const Point3 size = box.Max - box.Min;
  const double cell = std::max({ size[0], size[1], size[2] }) / 100.0;

  const std::array<double, 2> edge = this->Radii(vtkChokingLoops::EdgePaths);
  const std::array<double, 2> grid = this->Radii(vtkChokingLoops::GridDistance);
  const std::array<double, 2> marched = this->Radii(vtkChokingLoops::FastMarching);
  for (std::size_t k = 0; k < 2; ++k)
  {
    EXPECT_NEAR(twice[k], 2.0 * exact[k], 1e-12);
    EXPECT_GE(edge[k], exact[k] - 1e-12);
    EXPECT_LE(edge[k], exact[k] + excess);
    // A distance is 1-Lipschitz, and the nodes of a trilinear mean are at most a diagonal away.
    EXPECT_NEAR(grid[k], exact[k], std::sqrt(3.0) * cell);
    EXPECT_NEAR(marched[k], exact[k], 2.0 * std::sqrt(3.0) * cell); // first order: one cell more
  }
}

TEST_F(MorseFunctions, MeshMadeInside)
{
  TopologyFilterRun<vtkChokingLoops> run(this->Surface,
    [](vtkChokingLoops* filter)
    {
      filter->SetFiltration(vtkChokingLoops::TetrahedralMesh);
      filter->SetMinimumPersistenceUnit(vtkChokingLoops::Absolute);
      filter->SetMinimumPersistence(0.0);
    });
  const std::array<Found, 2> found = HandleAndTunnel(run);
  for (std::size_t k = 0; k < 2; ++k)
  {
    EXPECT_TRUE(found[k].Trusted);
    EXPECT_NEAR(found[k].Radius, this->Polyhedron[k], found[k].Uncertainty);
    EXPECT_LT(found[k].Uncertainty, 0.15);
  }
  vtkFieldData* facts = run.Surface(0)->GetFieldData();
  const auto number = [&](const char* name, vtkIdType side = 0)
  { return facts->GetArray(name)->GetTuple1(side); };
  EXPECT_EQ(number("NumberOfHandles"), 1.0);
  EXPECT_EQ(number("NumberOfTunnels"), 1.0);
  EXPECT_EQ(number("NumberOfAdditionalLoops", 0), 0.0); // a torus has no other narrowing
  EXPECT_EQ(number("NumberOfAdditionalLoops", 1), 0.0);
  EXPECT_GE(number("LargestSamplingError"), found[1].Uncertainty);
}

// Next to the faces of a cube, two triangles each, tetrahedra would be as large as the faces.
TEST(MorseFunctionsInside, TheyDifferWhereTheNearestPointIsNoPointOfTheMesh)
{
  Blocks cube(
    { 2, 2, 2 }, [](auto, auto, auto) { return true; }, true);
  // The cube's surface computed here: faces that only one tetrahedron has.
  std::map<std::set<std::int64_t>, std::pair<int, Triangle>> faces;
  for (const Tetrahedron& t : cube.Mesh.Tetrahedra)
  {
    for (const Triangle& face : std::array<Triangle, 4>{ { { t[0], t[2], t[1] },
           { t[0], t[1], t[3] }, { t[0], t[3], t[2] }, { t[1], t[2], t[3] } } })
    {
      auto& found = faces[{ face.begin(), face.end() }];
      ++found.first;
      found.second = face;
    }
  }
  TriangleMesh surface;
  surface.Points = cube.Mesh.Points;
  for (const auto& [corners, found] : faces)
  {
    if (found.first == 1)
    {
      surface.Triangles.push_back(found.second);
    }
  }
  ASSERT_EQ(surface.Triangles.size(), 48u);
  const auto inner =
    std::find(cube.Mesh.Points.begin(), cube.Mesh.Points.end(), Point3{ 1.0, 1.0, 1.0 });
  const auto middle = static_cast<std::size_t>(inner - cube.Mesh.Points.begin());
  *inner = { 1.3, 1.2, 1.0 };
  const auto value = [&](MorseFunction function)
  { return MorseValues(surface, cube.Mesh, function)[middle]; };
  EXPECT_NEAR(value(MorseFunction::ClosestPoint), 0.7, 1e-14);
  EXPECT_NEAR(value(MorseFunction::EdgePaths), std::sqrt(0.53), 1e-12); // to (2, 1, 1)
}

TEST(MorseFunctionsInside, SurfacesOfLargeTrianglesAreSplit)
{
  vtkNew<vtkPolyData> cube;
  SetMesh(Cube({ 0, 0, 0 }, 1.0), cube);
  TopologyFilterRun<vtkChokingLoops> run(
    cube, [](vtkChokingLoops* filter) { filter->SetFiltration(vtkChokingLoops::TetrahedralMesh); });
  EXPECT_EQ(run.Messages(), "");
  EXPECT_EQ(run.Surface(0)->GetNumberOfCells(), 0);
  vtkDataArray* error = run.Surface(0)->GetFieldData()->GetArray("LargestSamplingError");
  EXPECT_GT(error->GetTuple1(0), 0.0);
  EXPECT_LT(error->GetTuple1(0), 0.1);
}

// A mesh that is too coarse for the handle issues a message.
TEST_F(MorseFunctions, MeshTooCoarseIsNotTrusted)
{
  TetrahedralParameters parameters;
  parameters.Side = MeshedSide::Both;
  parameters.BoxMargin = 0.1;
  parameters.TetGen.MaximumVolume = 0.1;
  vtkNew<vtkPolyData> surface;
  const TriangleMesh ring = Torus(1.0, 0.3, 12, 6);
  SetMesh(ring, surface);
  vtkNew<vtkUnstructuredGrid> grid;
  SetTetrahedra(MeshTetrahedra(ring, parameters), grid);
  TopologyFilterRun<vtkChokingLoops> run(surface,
    [&](vtkChokingLoops* filter)
    {
      filter->SetInputData(1, grid);
      filter->SetFiltration(vtkChokingLoops::TetrahedralMesh);
    });
  EXPECT_NE(run.Messages().find("too coarse"), std::string::npos) << run.Messages();
  vtkCellData* loops = run.Surface(0)->GetCellData();
  EXPECT_EQ(loops->GetArray("Trusted")->GetRange()[0], 0.0);
}

TEST_F(MorseFunctions, BadOnesAreReported)
{
  const auto message = [&](const char* array, vtkUnstructuredGrid* grid)
  {
    TopologyFilterRun<vtkChokingLoops> run(this->Surface,
      [&](vtkChokingLoops* filter)
      {
        filter->SetInputData(1, grid);
        filter->SetFiltration(vtkChokingLoops::TetrahedralMesh);
        filter->SetMorseFunction(vtkChokingLoops::PointArray);
        filter->SetMorseArrayName(array);
      });
    EXPECT_EQ(run.Surface(0)->GetNumberOfCells(), 0);
    EXPECT_EQ(run.Surface(1)->GetNumberOfCells(), 0);
    return run.Messages();
  };
  EXPECT_NE(message("height", this->Grid).find("has no point array 'height'"), std::string::npos);
  this->AddArray("negative", -1.0);
  EXPECT_NE(message("negative", this->Grid).find("negative or not finite"), std::string::npos);
  this->AddArray("not a number", NAN);
  EXPECT_NE(message("not a number", this->Grid).find("negative or not finite"), std::string::npos);
  vtkNew<vtkUnstructuredGrid> moved;
  moved->DeepCopy(this->Grid);
  moved->GetPoints()->SetPoint(0, 0.123, 0.2, 0.3);
  EXPECT_NE(message("depth", moved).find("not a point of the tetrahedral mesh"), std::string::npos);
  const std::array<vtkIdType, 8> cube{ 0, 1, 2, 3, 4, 5, 6, 7 };
  moved->InsertNextCell(VTK_HEXAHEDRON, 8, cube.data());
  EXPECT_NE(message("depth", moved).find("is not a tetrahedron"), std::string::npos);
}

}
