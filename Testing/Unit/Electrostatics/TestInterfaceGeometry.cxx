// Crossings, normals and curvature of level sets that are known: a turned ellipsoid, whose level
// function is a polynomial that the differences reproduce, and the sides of nodes.

#include "Core/Geometry.h"
#include "Electrostatics/InterfaceGeometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>
#include <vector>

using namespace isthmus;

namespace
{

/// x A x + b x = 4, below 0 inside; with all mixed terms.
struct Ellipsoid
{
  std::array<std::array<double, 3>, 3> A{ { { 1.0, 0.3, -0.2 }, { 0.3, 1.4, 0.25 },
    { -0.2, 0.25, 0.8 } } };
  Point3 B{ 0.2, -0.1, 0.3 };

  double operator()(const Point3& x) const
  {
    double sum = -4.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      sum += this->B[i] * x[i];
      for (std::size_t j = 0; j < 3; ++j)
      {
        sum += this->A[i][j] * x[i] * x[j];
      }
    }
    return sum;
  }

  SurfaceFrame FrameAt(const Point3& x) const
  {
    Point3 gradient = this->B;
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        gradient[i] += 2.0 * this->A[i][j] * x[j];
      }
    }
    const double slope = Length(gradient);
    SurfaceFrame frame;
    frame.Normal = (1.0 / slope) * gradient;
    const auto projected = [&](std::size_t i, std::size_t j)
    {
      double sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        for (std::size_t l = 0; l < 3; ++l)
        {
          const double left = (i == k ? 1.0 : 0.0) - frame.Normal[i] * frame.Normal[k];
          const double right = (l == j ? 1.0 : 0.0) - frame.Normal[l] * frame.Normal[j];
          sum += left * 2.0 * this->A[k][l] * right / slope;
        }
      }
      return sum;
    };
    frame.Curvature = { projected(0, 0), projected(1, 1), projected(2, 2), projected(0, 1),
      projected(0, 2), projected(1, 2) };
    return frame;
  }
};

class InterfaceGeometry : public ::testing::Test
{
protected:
  InterfaceGeometry()
  {
    this->Box.Dimensions = { 27, 23, 25 };
    this->Box.Spacing = { 0.25, 0.3, 0.35 };
    this->Box.Corner = { 0.0, 0.0, 0.0 };
    for (std::int64_t node = 0; node < this->Box.Size(); ++node)
    {
      this->Values.push_back(this->Shape(this->Box.Position(node) - this->Center));
    }
    this->Level.Doubles = { this->Values.data(), this->Box.Dimensions,
      { this->Box.Spacing[0], this->Box.Spacing[1], this->Box.Spacing[2] } };
    this->Level.InsideIsHigher = false;
  }

  void ExpectFrame(const SurfaceFrame& frame, const Point3& x) const
  {
    const SurfaceFrame expected = this->Shape.FrameAt(x - this->Center);
    for (std::size_t i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(frame.Normal[i], expected.Normal[i], 1e-9);
    }
    for (std::size_t i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(frame.Curvature[i], expected.Curvature[i], 1e-8);
    }
  }

  const Ellipsoid Shape;
  const Point3 Center{ 3.21, 3.27, 4.13 };
  SolverBox Box;
  std::vector<double> Values;
  LevelFunction Level;
};

}

TEST_F(InterfaceGeometry, NodesAreInsideWhereTheFunctionIsNegative)
{
  const std::vector<unsigned char> inside = ClassifyNodes(this->Level, this->Box);
  ASSERT_EQ(inside.size(), this->Values.size());
  for (std::size_t n = 0; n < inside.size(); ++n)
  {
    EXPECT_EQ(inside[n] != 0, this->Values[n] < 0.0);
  }
}

TEST_F(InterfaceGeometry, EveryCrossedEdgeHasItsCrossingAndFrame)
{
  const std::vector<unsigned char> inside = ClassifyNodes(this->Level, this->Box);
  const auto crossings = FindCrossings(this->Level, this->Box, inside);
  std::set<std::pair<std::int64_t, int>> edges;
  for (const InterfaceCrossing& crossing : crossings)
  {
    const auto axis = static_cast<std::size_t>(crossing.Axis);
    edges.insert({ crossing.Node, crossing.Axis });
    EXPECT_NE(inside[static_cast<std::size_t>(crossing.Node)],
      inside[static_cast<std::size_t>(crossing.Node + this->Box.Steps()[axis])]);
    Point3 x = this->Box.Position(crossing.Node);
    x[axis] += crossing.Fraction * this->Box.Spacing[axis];
    EXPECT_NEAR(this->Shape(x - this->Center), 0.0, 1e-10);
    this->ExpectFrame(crossing.Frame, x);
  }
  std::size_t crossed = 0;
  for (std::int64_t node = 0; node < this->Box.Size(); ++node)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const std::int64_t at = node / (axis == 0 ? 1 : this->Box.Steps()[axis]);
      if (at % this->Box.Dimensions[axis] + 1 < this->Box.Dimensions[axis])
      {
        crossed += inside[static_cast<std::size_t>(node)] !=
          inside[static_cast<std::size_t>(node + this->Box.Steps()[axis])];
      }
    }
  }
  EXPECT_GT(crossed, 500u);
  EXPECT_EQ(crossings.size(), crossed);
  EXPECT_EQ(edges.size(), crossed);
}

TEST_F(InterfaceGeometry, PointsComeToTheLevelAlongTheGradient)
{
  const Point3 start = this->Center + Point3{ 1.2, 1.1, 0.4 };
  const Point3 x = OnLevel(this->Level, this->Box, start);
  EXPECT_NEAR(this->Shape(x - this->Center), 0.0, 1e-9);
  EXPECT_LT(Length(x - start), 0.5);
  this->ExpectFrame(isthmus::FrameAt(this->Level, this->Box, x), x);
}

TEST_F(InterfaceGeometry, ASurfaceAtTheBorderIsRefused)
{
  // Three nodes are needed beyond a crossing.
  SolverBox tight = this->Box;
  tight.First = { 0, 0, 8 };
  tight.Corner[2] += 8.0 * tight.Spacing[2];
  tight.Dimensions[2] -= 8;
  const std::vector<unsigned char> inside = ClassifyNodes(this->Level, tight);
  EXPECT_THROW(FindCrossings(this->Level, tight, inside), std::invalid_argument);
}
