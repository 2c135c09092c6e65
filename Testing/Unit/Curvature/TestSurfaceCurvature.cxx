// Curvature of meshes: spheres, areas, signs, invariances, points without curvature.

#include "Core/Geometry.h"
#include "Curvature/SurfaceCurvature.h"
#include "SharedData.h"
#include "SurfaceModels.h"
#include "TensorOptions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Weighted with the points' areas, as the thesis' tables are.
struct Statistics
{
  double Mean = 0.0;
  double Deviation = 0.0;
};

Statistics ComputeStatistics(const std::vector<double>& values, const std::vector<double>& areas)
{
  double area = 0.0, sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    area += areas[i];
    sum += areas[i] * values[i];
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    squares += (values[i] - sum / area) * (values[i] - sum / area);
  }
  return { sum / area, std::sqrt(squares / static_cast<double>(values.size())) };
}

}

TEST(SurfaceCurvature, SphereStatisticsOfTables42And43)
{
  const struct
  {
    int Frequency;
    double RadiusSquared;
    double MeanK;
    double MeanH;
  } rows[] = { { 10, 1.0, 1.003239, 1.000031 }, { 14, 2.0, 0.500804, 0.707106 },
    { 17, 3.0, 0.333685, 0.577343 } };
  for (const auto& row : rows)
  {
    const Model sphere = Icosphere(row.Frequency, std::sqrt(row.RadiusSquared));
    double deviationK[2] = { 0.0, 0.0 };
    for (const DualArea rule : { DualArea::Voronoi, DualArea::Barycentric })
    {
      SurfaceCurvatureOptions options;
      options.DualArea = rule;
      const SurfaceCurvatureResult result = ComputeSurfaceCurvature(sphere.View(), options);
      const Statistics k = ComputeStatistics(result.Gaussian, result.Area);
      const Statistics h = ComputeStatistics(result.Mean, result.Area);
      std::printf("r^2 = %g %-11s mean K %.6f (printed %.6f) sd %.6f, mean H %.6f (%.6f) sd %.6f\n",
        row.RadiusSquared, rule == DualArea::Voronoi ? "Voronoi" : "barycentric", k.Mean, row.MeanK,
        k.Deviation, h.Mean, row.MeanH, h.Deviation);
      EXPECT_NEAR(k.Mean, row.MeanK, 1e-3);
      EXPECT_NEAR(h.Mean, row.MeanH, 1e-3);
      deviationK[rule == DualArea::Voronoi ? 0 : 1] = k.Deviation;
    }
    EXPECT_LT(deviationK[0], deviationK[1]);
  }
  const SurfaceCurvatureResult unit = ComputeSurfaceCurvature(Icosphere(10, 1.0).View(), {});
  EXPECT_NEAR(ComputeStatistics(unit.Gaussian, unit.Area).Mean, 1.003081, 1e-6);
  EXPECT_NEAR(ComputeStatistics(unit.Gaussian, unit.Area).Deviation, 0.000375, 1e-5);
}

TEST(SurfaceCurvature, AreasArePartitionsAndDefectsSumToTheEulerNumber)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  const Model mesh = ReadOFF((SharedDataFolder() / "surfaces/fertility.off").string());
  double areas[3] = { 0, 0, 0 };
  for (const DualArea rule : { DualArea::Voronoi, DualArea::Barycentric, DualArea::Mixed })
  {
    SurfaceCurvatureOptions options;
    options.DualArea = rule;
    const auto result = ComputeSurfaceCurvature(mesh.View(), options);
    double total = 0.0;
    for (std::size_t i = 0; i < result.Area.size(); ++i)
    {
      total += result.Gaussian[i] * result.Area[i];
      areas[static_cast<int>(rule)] += result.Area[i];
    }
    if (rule != DualArea::Voronoi)
    {
      EXPECT_EQ(result.AreaNotPositive, 0);
      EXPECT_NEAR(total, 2.0 * Pi * -6.0, 1e-9) << "Gauss and Bonnet, genus 4";
    }
  }
  EXPECT_NEAR(areas[1] / areas[0], 1.0, 1e-12);
  EXPECT_NEAR(areas[2] / areas[0], 1.0, 1e-12);
}

TEST(SurfaceCurvature, OrientationDecidesTheSign)
{
  Model sphere = Icosphere(6, 2.0);
  Model cap = Sheet(6,
    [](double u, double v) {
      return Vector{ u, v, std::sqrt(4.0 - u * u - v * v) };
    });
  for (const auto estimate :
    { CurvatureEstimate::AngleDefect, CurvatureEstimate::EdgeTensor, CurvatureEstimate::NormalFit })
  {
    SurfaceCurvatureOptions options;
    options.Method = estimate;
    const auto outward = ComputeSurfaceCurvature(sphere.View(), options);
    EXPECT_NEAR(outward.Mean[0], 0.5, 0.05);
    TurnInsideOut(sphere);
    const auto inward = ComputeSurfaceCurvature(sphere.View(), options);
    EXPECT_NEAR(inward.Mean[0], outward.Mean[0], 1e-12);
    options.Orientation = SurfaceOrientation::AsWound;
    EXPECT_NEAR(ComputeSurfaceCurvature(sphere.View(), options).Mean[0], -outward.Mean[0], 1e-12);
    options.Orientation = SurfaceOrientation::Reversed;
    EXPECT_NEAR(ComputeSurfaceCurvature(sphere.View(), options).Mean[0], outward.Mean[0], 1e-12);
    TurnInsideOut(sphere);

    options.Orientation = SurfaceOrientation::Automatic; // open: as wound
    EXPECT_GT(ComputeSurfaceCurvature(cap.View(), options).Mean[24], 0.4);
    TurnInsideOut(cap);
    EXPECT_LT(ComputeSurfaceCurvature(cap.View(), options).Mean[24], -0.4);
    TurnInsideOut(cap);
  }
}

// Each closed component is oriented by the components that contain it, not by the volume of the
// whole: a ball beside another, a cavity, a ball in the cavity, whichever way each is wound, and
// beside an open sheet.
TEST(SurfaceCurvature, NestedShellsAreOrientedByNesting)
{
  const Vector places[] = { { 0.0, 0.0, 0.0 }, { 0.1, 0.2, 0.0 }, { 0.1, 0.1, 0.1 },
    { 9.0, 1.0, 0.0 } };
  const double radii[] = { 4.0, 2.5, 1.0, 2.0 };
  const double signs[] = { 1.0, -1.0, 1.0, 1.0 };
  const Model cap = Sheet(6,
    [](double u, double v) {
      return Vector{ u, v, std::sqrt(4.0 - u * u - v * v) };
    });
  for (const auto estimate :
    { CurvatureEstimate::AngleDefect, CurvatureEstimate::EdgeTensor, CurvatureEstimate::NormalFit })
  {
    for (unsigned turned = 0; turned < 16; ++turned)
    {
      Model all;
      std::vector<std::size_t> first;
      for (unsigned s = 0; s < 4; ++s)
      {
        Model shell = Icosphere(4, radii[s]);
        if ((turned >> s) & 1u)
        {
          TurnInsideOut(shell);
        }
        first.push_back(all.Points.size());
        Append(all, shell, places[s]);
      }
      const std::size_t sheet = all.Points.size();
      Append(all, cap, { -9.0, 0.0, 0.0 });
      SurfaceCurvatureOptions options;
      options.Method = estimate;
      const auto result = ComputeSurfaceCurvature(all.View(), options);
      for (unsigned s = 0; s < 4; ++s)
      {
        EXPECT_NEAR(result.Mean[first[s] + 5] * radii[s], signs[s], 0.1) << turned << " " << s;
      }
      EXPECT_GT(result.Mean[sheet + 24], 0.4);
    }
  }
}

TEST(SurfaceCurvature, InvariantUnderMotionScaleAndOrder)
{
  const Model torus = Torus(48, 24, 2.0, 0.7);
  const double c = std::cos(0.7), s = std::sin(0.7), scale = 3.0;
  Model moved = torus;
  for (Vector& p : moved.Points)
  {
    p = { 100.0 + scale * (c * p[0] - s * p[2]), scale * p[1] - 50.0,
      scale * (s * p[0] + c * p[2]) };
  }
  std::reverse(moved.Triangles.begin(), moved.Triangles.end());
  for (const auto& options :
    { SurfaceCurvatureOptions{}, Tensor(CurvatureNeighbourhood::Ball), Fit() })
  {
    const auto a = ComputeSurfaceCurvature(torus.View(), options);
    const auto b = ComputeSurfaceCurvature(moved.View(), options);
    for (std::size_t i = 0; i < torus.Points.size(); ++i)
    {
      EXPECT_NEAR(a.Mean[i], scale * b.Mean[i], 1e-10);
      EXPECT_NEAR(a.Gaussian[i], scale * scale * b.Gaussian[i], 1e-9);
    }
  }
}

TEST(SurfaceCurvature, PointsWithoutCurvatureAreMarked)
{
  Model model = Icosphere(4, 1.0);
  model.AddPoint(9, 9, 9);
  const vtkIdType extra = model.AddPoint(3, 0, 0);
  model.Triangles.push_back({ model.Triangles[0][0], model.Triangles[0][1], extra });
  const vtkIdType thin = model.AddPoint(5, 0, 0);
  model.AddPoint(6, 0, 0);
  model.AddPoint(7, 0, 0);
  model.Triangles.push_back({ thin, thin + 1, thin + 2 });
  for (const auto& options : { SurfaceCurvatureOptions{}, Tensor(CurvatureNeighbourhood::Ball, 0.4),
         Tensor(CurvatureNeighbourhood::GeodesicDisc, 0.4), Fit(0.4) })
  {
    const auto result = ComputeSurfaceCurvature(model.View(), options);
    EXPECT_EQ(result.IrregularPoints, 2);
    EXPECT_GE(result.DegeneratePoints, 3 - (options.Method == CurvatureEstimate::AngleDefect) * 3);
    for (const vtkIdType point : { extra - 1, thin, model.Triangles[0][0] })
    {
      EXPECT_EQ(result.Valid[static_cast<std::size_t>(point)], 0);
      EXPECT_EQ(result.Mean[static_cast<std::size_t>(point)], 0.0);
    }
    for (std::size_t i = 0; i < result.Mean.size(); ++i)
    {
      EXPECT_TRUE(std::isfinite(result.Mean[i]) && std::isfinite(result.Gaussian[i]));
    }
  }
  EXPECT_THROW(ComputeSurfaceCurvature(model.View(), Tensor(CurvatureNeighbourhood::Ball, -1.0)),
    std::invalid_argument);
  EXPECT_TRUE(ComputeSurfaceCurvature(Model{}.View(), {}).Mean.empty());
  EXPECT_THROW(ComputeSurfaceCurvature(model.View(), {}, [](double) { return false; }), Cancelled);
}
