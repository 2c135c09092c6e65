// Crossings and normals of sampled solids with sharp edges: exact on planes, of their orders on
// smooth sets, no worse than central differences on noise; and the edges that dual contouring keeps
// of volumes.

#include "Contouring/ENOCrossings.h"

#include "DualContours.h"
#include "EdgedSolids.h"
#include "Remeshing/SelfIntersections.h"
#include "SharedData.h"
#include "vtkMRCMapReader.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

vtkSmartPointer<vtkImageData> Rotate(int n, const Value& value, const Rotation& turn)
{
  return SampleImage(n, [&](const Point3& p) { return -value(turn(p)); });
}

struct KeptShares
{
  double All = 0.0, FarFromCorners = 0.0; ///< shares
  std::size_t Crossing = 0;               ///< triangles
};

KeptShares FilterCrossings(
  const Value& value, const TriangleMesh& all, const TriangleMesh& far, int n)
{
  KeptShares kept;
  constexpr unsigned turns = 3;
  for (unsigned seed = 1; seed <= turns; ++seed)
  {
    const Rotation turn(seed);
    const TriangleMesh contour = ComputeContour(Rotate(n, value, turn));
    const auto share = [&](TriangleMesh edges)
    {
      for (Point3& p : edges.Points)
      {
        p = turn.Back(p);
      }
      return ShareWithin(edges, contour, 0.05 * 2.0 / (n - 1));
    };
    kept.All += share(all) / turns;
    kept.FarFromCorners += share(far) / turns;
    kept.Crossing += SelfIntersections(contour).size();
  }
  return kept;
}

std::vector<GridCrossing> FindCrossings(vtkImageData* image, double level, bool eno)
{
  std::vector<double> values;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    values.push_back(image->GetPointData()->GetScalars()->GetComponent(i, 0));
  }
  GridView<const double> grid;
  grid.Data = values.data();
  for (std::size_t a = 0; a < 3; ++a)
  {
    grid.Dimensions[a] = image->GetDimensions()[a];
    grid.Spacing[a] = image->GetSpacing()[a];
  }
  std::vector<GridCrossing> crossings;
  for (std::int64_t k = 0; k < grid.Dimensions[2]; ++k)
  {
    const LevelView<double> view{ grid, level, true };
    eno ? AppendENOCrossings(view, k, crossings) : AppendLevelCrossings(view, k, crossings);
  }
  return crossings;
}

Point3 GetPosition(vtkImageData* image, const GridCrossing& crossing)
{
  Point3 p;
  image->GetPoint(crossing.Node, p.data());
  p[static_cast<std::size_t>(crossing.Axis)] += crossing.Fraction * image->GetSpacing()[0];
  return p;
}

/// A copy with normal noise of a tenth of the values' deviation.
vtkSmartPointer<vtkImageData> WithNoise(vtkImageData* map, unsigned seed)
{
  auto noisy = vtkSmartPointer<vtkImageData>::New();
  noisy->DeepCopy(map);
  vtkDataArray* const values = noisy->GetPointData()->GetScalars();
  double sum = 0.0, squares = 0.0;
  const auto count = static_cast<double>(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    sum += value / count;
    squares += value * value / count;
  }
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 0.1 * std::sqrt(squares - sum * sum));
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetComponent(i, 0, values->GetComponent(i, 0) + normal(random));
  }
  return noisy;
}

/// Root mean square of the angle between normals, in radians, where both have a crossing.
double AngleBetween(const std::vector<GridCrossing>& a, const std::vector<GridCrossing>& b)
{
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();)
  {
    const auto key = [](const GridCrossing& c) { return 3 * c.Node + c.Axis; };
    if (key(a[i]) == key(b[j]))
    {
      const double d = Length(Point3(a[i].Normal) - Point3(b[j].Normal));
      sum += d * d;
      ++count;
    }
    const bool both = key(a[i]) == key(b[j]), first = key(a[i]) < key(b[j]);
    i += both || first ? 1 : 0;
    j += both || !first ? 1 : 0;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

}

/// Acceptance 2 for volumes. Two planes cannot be distinguished within two spacings of a corner,
/// where pieces are thinner than three nodes: those edges are counted in the first number only.
TEST(ENOCrossings, EdgesOfSampledSolidsAreKept)
{
  struct Case
  {
    const char* Name;
    Value Solid;
    TriangleMesh Edges, FarFromCorners;
    double Least, LeastFar;
  };
  constexpr int n = 65;
  constexpr double h = 2.0 / (n - 1), corner = 3.0 * h;
  for (const Case& c :
    { Case{ "cube", Box, BoxEdges(0, false), BoxEdges(corner, false), 0.985, 0.998 },
      { "distance of a cube", BoxDistance, BoxEdges(0, false), BoxEdges(corner, false), 0.98,
        0.995 },
      { "octahedron", OctahedronValue, OctahedronEdges(0), OctahedronEdges(corner), 0.95, 0.995 },
      { "box without ball", BoxWithoutBall, BoxEdges(0, true), BoxEdges(corner, true), 0.97,
        0.975 },
      { "box and ball", BoxAndBall, BoxEdges(0, true), BoxEdges(corner, true), 0.9, 0.905 } })
  {
    const KeptShares kept = FilterCrossings(c.Solid, c.Edges, c.FarFromCorners, n);
    std::printf("%s: %.2f %% of the edges within 0.05 h, %.2f %% of those 3 h from corners; %zu "
                "triangles cross in three turns\n",
      c.Name, 100.0 * kept.All, 100.0 * kept.FarFromCorners, kept.Crossing);
    EXPECT_GT(kept.All, c.Least) << c.Name;
    EXPECT_GT(kept.FarFromCorners, c.LeastFar) << c.Name;
  }
}

/// Nodes on the planes where two faces are equally far, and edges in the nodes' planes.
TEST(ENOCrossings, CubeAlongTheGridIsExact)
{
  for (const double shift : { 0.0, 0.013 })
  {
    const auto image = SampleImage(33,
      [shift](const Point3& p) {
        return 0.013 - Box(p - Point3{ shift, shift, shift });
      });
    for (const GridCrossing& crossing : FindCrossings(image, 0.0, true))
    {
      const Point3 p = GetPosition(image, crossing) - Point3{ shift, shift, shift };
      EXPECT_NEAR(Box(p), 0.013, 1e-12);
      const auto axis = static_cast<std::size_t>(crossing.Axis);
      EXPECT_NEAR(crossing.Normal[axis], p[axis] > 0.0 ? 1.0 : -1.0, 1e-12);
    }
  }
}

TEST(ENOCrossings, SmoothSetsKeepTheirOrders)
{
  double last = 0.0, lastNormal = 0.0;
  for (const int n : { 17, 33, 65 })
  {
    const auto image = SampleImage(n,
      [](const Point3& p) {
        return 0.7 - Length(p - Point3{ 0.01, 0.02, 0.03 });
      });
    double off = 0.0, turned = 0.0;
    for (const GridCrossing& crossing : FindCrossings(image, 0.0, true))
    {
      const Point3 r = GetPosition(image, crossing) - Point3{ 0.01, 0.02, 0.03 };
      off = std::max(off, std::abs(Length(r) - 0.7));
      turned = std::max(turned, Length((1.0 / Length(r)) * r - Point3(crossing.Normal)));
    }
    std::printf("%d nodes: crossings off by %.2e, normals by %.2e\n", n, off, turned);
    if (last > 0.0)
    {
      EXPECT_GT(std::log2(last / off), 2.5);
      EXPECT_GT(std::log2(lastNormal / turned), 1.7);
    }
    last = off;
    lastNormal = turned;
  }
}

/// A ball with noise: normals compared with the true ones, by both methods.
TEST(ENOCrossings, NoiseTurnsNormalsNoMore)
{
  for (const double noise : { 0.02, 0.1, 0.3, 1.0 })
  {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    const auto truth = SampleImage(33, [](const Point3& p) { return 0.7 - Length(p); });
    const auto noisy = SampleImage(
      33, [&](const Point3& p) { return 0.7 - Length(p) + noise / 16.0 * normal(random); });
    const auto exact = FindCrossings(truth, 0.0, true);
    const double central = AngleBetween(FindCrossings(noisy, 0.0, false), exact);
    const double eno = AngleBetween(FindCrossings(noisy, 0.0, true), exact);
    std::printf(
      "noise of %g h: normals off by %.4f, by central differences %.4f\n", noise, eno, central);
    EXPECT_LT(eno, 1.05 * central);
  }
}

/// Maps with noise of a tenth of their deviation, drawn twice: the angles between the resulting
/// normals.
TEST(ENOCrossings, NoiseOnMapsTurnsNormalsNoMore)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps");
  for (const auto& [name, level] : { std::pair{ "emd_1832.map", 0.46 }, { "emd_5043.map", 2.4 } })
  {
    vtkNew<vtkMRCMapReader> reader;
    reader->SetFileName((SharedDataFolder() / "maps" / name).string().c_str());
    reader->Update();
    std::array<std::vector<GridCrossing>, 2> eno, central;
    for (const std::size_t draw : { 0u, 1u })
    {
      const auto map = WithNoise(reader->GetOutput(), static_cast<unsigned>(draw));
      eno[draw] = FindCrossings(map, level, true);
      central[draw] = FindCrossings(map, level, false);
    }
    const double disagree = AngleBetween(eno[0], eno[1]);
    const double before = AngleBetween(central[0], central[1]);
    std::printf(
      "%s: normals disagree by %.4f, by central differences %.4f\n", name, disagree, before);
    EXPECT_LT(disagree, 1.05 * before);
  }
}

TEST(ENOCrossings, FewNodesAndFlatPlacesGiveNormals)
{
  for (const int n : { 2, 3, 4 })
  {
    const auto image = SampleImage(n, [](const Point3& p) { return p[0] > 0.0 ? 1.0 : -1.0; });
    const auto crossings = FindCrossings(image, 0.0, true);
    EXPECT_EQ(crossings.size(), static_cast<std::size_t>(n * n));
    for (const GridCrossing& crossing : crossings)
    {
      EXPECT_NEAR(crossing.Fraction, 0.5, 1e-9);
      EXPECT_NEAR(crossing.Normal[0], -1.0, 1e-9);
    }
  }
}

/// Second differences at the two nodes are 2 and 1: the crossing is of the parabola with 1.
TEST(ENOCrossings, CrossingIsOfTheFlatterParabola)
{
  const std::array<double, 4> values{ 6.0, 1.0, -2.0, -4.0 };
  for (const double direction : { 1.0, -1.0 })
  {
    const auto image = SampleImage(4,
      [&](const Point3& p)
      { return values[static_cast<std::size_t>(std::lround(1.5 * (direction * p[0] + 1.0)))]; });
    const auto crossings = FindCrossings(image, 0.0, true);
    ASSERT_EQ(crossings.size(), 16u);
    for (const GridCrossing& crossing : crossings)
    {
      // 1 - 3 t + t (t - 1) / 2 = 0
      const double fromHigh = 3.5 - std::sqrt(10.25);
      EXPECT_NEAR(crossing.Fraction, direction > 0.0 ? fromHigh : 1.0 - fromHigh, 1e-9);
    }
  }
}

TEST(ENOCrossings, NormalsNearTheBorderAreSecondOrder)
{
  const auto image = SampleImage(4, [](const Point3& p) { return 0.5 - p[0] - p[1] * p[1]; });
  int found = 0;
  for (const GridCrossing& crossing : FindCrossings(image, 0.0, true))
  {
    const Point3 p = GetPosition(image, crossing);
    if (crossing.Axis == 0 && std::abs(p[1]) < 0.5)
    {
      EXPECT_NEAR(crossing.Normal[1] / crossing.Normal[0], 2.0 * p[1], 1e-9);
      ++found;
    }
  }
  EXPECT_EQ(found, 8);
}
