// Round a wire that runs through a neck, the membrane is an annulus: one feature with two
// loops, one on the neck and one on the wire.

#include "BeadShapes.h"
#include "vtkChokingLoops.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkLogger.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <map>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// The report of the filter for one feature.
struct ReportedFeature
{
  int Kind = 0;
  int Side = 0;
  double Radius = 0.0;
  double Area = 0.0;
  std::vector<double> Lengths; ///< descending
  std::vector<Point3> Middles; ///< of the loops, in that order
};

class ShownFeatures
{
public:
  explicit ShownFeatures(const TriangleMesh& mesh)
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_ERROR);
    vtkNew<vtkPolyData> surface;
    SetMesh(mesh, surface);
    this->Filter->SetInputData(surface);
    this->Filter->Update();
    vtkPolyData* loops = this->Filter->GetOutput();
    vtkCellData* data = loops->GetCellData();
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < loops->GetNumberOfCells(); ++c)
    {
      const auto at = [&](const char* name) { return data->GetArray(name)->GetTuple1(c); };
      ReportedFeature& reported = this->Features[static_cast<int>(at("FeatureId"))];
      reported.Kind = static_cast<int>(at("Kind"));
      reported.Side = static_cast<int>(at("Side"));
      reported.Radius = at("Radius");
      loops->GetLines()->GetCellAtId(c, ids);
      Point3 sum{ 0.0, 0.0, 0.0 };
      for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
      {
        Point3 p;
        loops->GetPoint(ids->GetId(i), p.data());
        sum = sum + p;
      }
      const double length = at("Length");
      const auto place = std::upper_bound(
        reported.Lengths.begin(), reported.Lengths.end(), length, std::greater<>());
      reported.Middles.insert(reported.Middles.begin() + (place - reported.Lengths.begin()),
        (1.0 / static_cast<double>(ids->GetNumberOfIds() - 1)) * sum);
      reported.Lengths.insert(place, length);
    }
    this->AddAreas();
  }

  double FieldValue(const char* name, int component = 0) const
  {
    return this->Filter->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(component);
  }

  /// The features inside that have two loops.
  std::vector<ReportedFeature> Annular() const
  {
    std::vector<ReportedFeature> annular;
    for (const auto& [id, reported] : this->Features)
    {
      std::cout << "kind " << reported.Kind << " side " << reported.Side << " radius "
                << reported.Radius << " area " << reported.Area << " loops";
      for (const double length : reported.Lengths)
      {
        std::cout << " " << length;
      }
      std::cout << "\n";
      if (reported.Side == 0 && reported.Lengths.size() == 2)
      {
        annular.push_back(reported);
      }
    }
    return annular;
  }

  std::map<int, ReportedFeature> Features;

private:
  void AddAreas()
  {
    auto* membranes = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1));
    vtkNew<vtkIdList> ids;
    for (vtkIdType c = 0; c < membranes->GetNumberOfCells(); ++c)
    {
      membranes->GetCellPoints(c, ids);
      Point3 p[3];
      for (vtkIdType k = 0; k < 3; ++k)
      {
        membranes->GetPoint(ids->GetId(k), p[k].data());
      }
      const double id = membranes->GetCellData()->GetArray("FeatureId")->GetTuple1(c);
      this->Features[static_cast<int>(id)].Area += TriangleArea(p[0], p[1], p[2]);
    }
  }

  vtkNew<vtkChokingLoops> Filter;
};

constexpr double NeckRadius = 0.4;
constexpr double WireRadius = 0.12;
constexpr double OffAxis = 0.05; ///< so that the ball can pass only at one place

/// Widest at 1.2 beside the waist at 0, closed at 1.9.
double WireAt(double z)
{
  const double u = z / 1.9;
  return (WireRadius + 0.08 * z * z) * std::pow(std::max(0.0, 1.0 - u * u * u * u), 0.5);
}

/// A dumbbell with a wire in it that touches nothing.
TriangleMesh FreeWire()
{
  const TriangleMesh body = Revolution(
    [](double z) { return 2.0 * DumbbellRadius(z / 2.0, 0.5 * NeckRadius); }, -4.0, 4.0, 60, 160);
  TriangleMesh wire = Revolution(WireAt, -1.9, 1.9, 30, 100);
  for (Triangle& t : wire.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  for (Point3& p : wire.Points)
  {
    p[0] += OffAxis;
  }
  return Together(body, wire);
}

/// The annulus at the neck: a ball passes where it is widest.
void ExpectNeck(const ReportedFeature& reported)
{
  EXPECT_NEAR(reported.Radius, 0.5 * (NeckRadius - WireRadius + OffAxis), 0.01);
  ASSERT_EQ(reported.Lengths.size(), 2U);
  EXPECT_NEAR(reported.Lengths[0], 2.0 * M_PI * NeckRadius, 0.02 * 2.0 * M_PI * NeckRadius);
  EXPECT_NEAR(reported.Lengths[1], 2.0 * M_PI * WireRadius, 0.05 * 2.0 * M_PI * WireRadius);
  EXPECT_NEAR(reported.Middles[0][2], 0.0, 0.1);
  EXPECT_NEAR(reported.Middles[1][2], 0.0, 0.1);
  EXPECT_NEAR(reported.Middles[1][0], OffAxis, 0.02);
  const double area = M_PI * (NeckRadius * NeckRadius - WireRadius * WireRadius);
  EXPECT_NEAR(reported.Area, area, 0.05 * area);
}

TEST(AnnularMembranes, RoundAFreeWireThroughANeck)
{
  const ShownFeatures shown(FreeWire());
  const std::vector<ReportedFeature> annular = shown.Annular();
  ASSERT_EQ(annular.size(), 1U);
  EXPECT_EQ(annular[0].Kind, 2);
  ExpectNeck(annular[0]);
  EXPECT_EQ(shown.FieldValue("NumberOfHandles"), 0.0);
  EXPECT_EQ(shown.FieldValue("NumberOfTunnels"), 0.0);
  EXPECT_EQ(shown.FieldValue("NumberOfAdditionalLoops"), 1.0) << "two loops, but one feature";
}

// The wire leaves the dumbbell at both ends: the inside is a ring around it, with one handle and
// one tunnel, and the annulus at the neck is a further feature.
TEST(AnnularMembranes, RoundAWireThatGoesThrough)
{
  const auto inside = [](double x, double y, double z)
  {
    const double body = std::hypot(x, y) - 2.0 * DumbbellRadius(z / 2.0, 0.5 * NeckRadius);
    const double wire = WireRadius + 0.03 * z * z - std::hypot(x - OffAxis, y);
    return std::max(body, wire);
  };
  const TriangleMesh mesh =
    LevelSet(inside, { -2.213, -2.213, -4.413 }, { 2.213, 2.213, 4.413 }, { 88, 88, 176 });
  const ShownFeatures shown(mesh);
  const std::vector<ReportedFeature> annular = shown.Annular();
  ASSERT_EQ(annular.size(), 1U);
  ExpectNeck(annular[0]);
  EXPECT_EQ(shown.FieldValue("NumberOfHandles"), 1.0);
  EXPECT_EQ(shown.FieldValue("NumberOfTunnels"), 1.0);
}

// A tube with a waist, closed to a ring, and a wire in it that is closed to a ring as well. Of the
// four classes of the two tori's loops, each bounds in the space between them together with its
// counterpart: round the tube, and along it. The handle at the waist is an annulus.
TEST(AnnularMembranes, RoundAWireClosedToARing)
{
  const auto circle = [](double shift)
  {
    return [shift](double u)
    {
      const double angle = 2.0 * M_PI * u;
      return Point3{ 1.5 * std::cos(angle), 1.5 * std::sin(angle), shift };
    };
  };
  const Tube tube{ circle(0.0), 0.6, NeckRadius, 0.3 };
  const Tube wire{ circle(OffAxis), 0.15, WireRadius, 0.3 };
  TriangleMesh inner = TubeSurface(wire, 300, 24);
  for (Triangle& t : inner.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  const ShownFeatures shown(Together(TubeSurface(tube, 160, 48), inner));
  EXPECT_EQ(shown.FieldValue("NumberOfHandles"), 2.0);
  EXPECT_EQ(shown.FieldValue("NumberOfTunnels"), 2.0);
  const std::vector<ReportedFeature> annular = shown.Annular();
  const auto waist = std::find_if(annular.begin(), annular.end(),
    [](const ReportedFeature& reported) { return reported.Lengths[0] < 4.0; });
  ASSERT_NE(waist, annular.end());
  EXPECT_NEAR(waist->Radius, 0.5 * (NeckRadius - WireRadius + OffAxis), 0.01);
  EXPECT_NEAR(waist->Lengths[0], 2.0 * M_PI * NeckRadius, 0.02 * 2.0 * M_PI * NeckRadius);
  EXPECT_NEAR(waist->Lengths[1], 2.0 * M_PI * WireRadius, 0.03 * 2.0 * M_PI * WireRadius);
}

}
