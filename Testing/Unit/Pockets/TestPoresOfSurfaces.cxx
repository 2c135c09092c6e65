// Pores of a map and of a closed surface: a pipe of known width, and its tunnel's membrane.

#include "Core/TriangleMesh.h"
#include "vtkChokingLoops.h"
#include "vtkMapSurface.h"
#include "vtkPoreProfile.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace isthmus;

namespace
{

constexpr double Throat = 4.0;

/// The bore of the pipe at height z.
double BoreAt(double z)
{
  return Throat + 0.02 * z * z;
}

/// A map that is above 0 in the wall of a pipe along z, 28 long and 28 wide.
vtkSmartPointer<vtkImageData> PipeMap()
{
  auto map = vtkSmartPointer<vtkImageData>::New();
  map->SetDimensions(51, 51, 51);
  map->SetSpacing(0.7, 0.7, 0.7);
  map->SetOrigin(-17.4, -17.6, -17.3);
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    double p[3];
    map->GetPoint(i, p);
    const double rho = std::hypot(p[0], p[1]);
    values->InsertNextValue(
      static_cast<float>(std::min({ rho - BoreAt(p[2]), 14.0 - rho, 14.0 - std::fabs(p[2]) })));
  }
  map->GetPointData()->SetScalars(values);
  return map;
}

vtkSmartPointer<vtkPolyData> PipeSurface()
{
  vtkNew<vtkMapSurface> surface;
  surface->SetInputData(PipeMap());
  surface->SetLevel(0.0);
  surface->Update();
  return surface->GetOutput();
}

Point3 At(vtkPolyData* data, vtkIdType point)
{
  Point3 p;
  data->GetPoint(point, p.data());
  return p;
}

/// Whether the segment from a to b goes through a triangle.
bool Crosses(const Point3& a, const Point3& b, const std::array<Point3, 3>& t)
{
  const auto side = [](const Point3& p, const Point3& q, const Point3& r, const Point3& s)
  { return Dot(q - p, Cross(r - p, s - p)) > 0.0; };
  const bool first = side(a, b, t[0], t[1]);
  return side(a, t[0], t[1], t[2]) != side(b, t[0], t[1], t[2]) &&
    side(a, b, t[1], t[2]) == first && side(a, b, t[2], t[0]) == first;
}

}

TEST(PoresOfSurfaces, APipeHasItsBoreAlongTheAxis)
{
  const auto surface = PipeSurface();
  ASSERT_GT(surface->GetNumberOfPoints(), 1000);
  vtkNew<vtkPoreProfile> pores;
  pores->SetInputData(surface);
  pores->SetMinimumSpan(10.0);
  pores->Update();
  ASSERT_EQ(pores->GetPoreTable()->GetNumberOfRows(), 1);
  EXPECT_NEAR(pores->GetPoreTable()->GetValueByName(0, "Radius").ToDouble(), Throat, 0.03);
  auto* radius = pores->GetOutput()->GetPointData()->GetArray("Radius");
  for (vtkIdType i = 0; i < pores->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const Point3 p = At(pores->GetOutput(), i);
    // The nearest point of the wall, from the axis; a mesh has no point exactly there.
    double least = HUGE_VAL;
    for (double z = -14.0; z <= 14.0; z += 0.01)
    {
      least = std::min(least, std::hypot(BoreAt(z), z - p[2]));
    }
    EXPECT_LT(std::hypot(p[0], p[1]), 0.4) << i;
    EXPECT_NEAR(radius->GetComponent(i, 0), least, 0.06) << i;
  }
  auto* notes =
    vtkStringArray::SafeDownCast(pores->GetOutput()->GetFieldData()->GetAbstractArray("Notes"));
  ASSERT_TRUE(notes); // the width below which channels were not searched for
  EXPECT_NE(notes->GetValue(notes->GetNumberOfValues() - 1).find("apart"), std::string::npos);
}

TEST(PoresOfSurfaces, ATunnelsMembraneIsCrossedOnce)
{
  const auto surface = PipeSurface();
  vtkNew<vtkPoreProfile> pores;
  pores->SetInputData(surface);
  pores->SetMinimumSpan(10.0);
  pores->Update();
  vtkPolyData* line = pores->GetOutput();
  ASSERT_EQ(line->GetNumberOfLines(), 1);
  vtkNew<vtkChokingLoops> loops;
  loops->SetInputData(surface);
  loops->Update();
  auto* membranes = vtkPolyData::SafeDownCast(loops->GetOutputDataObject(1));
  auto* kind = membranes->GetCellData()->GetArray("Kind");
  int crossings = 0;
  int tunnels = 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < membranes->GetNumberOfCells(); ++c)
  {
    if (kind->GetComponent(c, 0) != 1.0)
    {
      continue;
    }
    ++tunnels;
    membranes->GetCellPoints(c, corners);
    const std::array<Point3, 3> triangle{ At(membranes, corners->GetId(0)),
      At(membranes, corners->GetId(1)), At(membranes, corners->GetId(2)) };
    for (vtkIdType i = 0; i + 1 < line->GetNumberOfPoints(); ++i)
    {
      crossings += Crosses(At(line, i), At(line, i + 1), triangle) ? 1 : 0;
    }
  }
  ASSERT_GT(tunnels, 0);
  EXPECT_EQ(crossings, 1);
}

TEST(PoresOfSurfaces, TwoPointsAndADirectionFollowTheBore)
{
  const auto surface = PipeSurface();
  for (const int mode : { vtkPoreProfile::TwoPoints, vtkPoreProfile::PointAndDirection })
  {
    vtkNew<vtkPoreProfile> pores;
    pores->SetInputData(surface);
    pores->SetMode(mode);
    pores->SetPoint1(0, 0, -6);
    pores->SetPoint2(0, 0, 6);
    pores->SetPoint(0.5, 0.2, 1.0);
    pores->SetDirection(0, 0, 1);
    pores->Update();
    ASSERT_EQ(pores->GetPoreTable()->GetNumberOfRows(), 1) << mode;
    EXPECT_NEAR(pores->GetPoreTable()->GetValueByName(0, "Radius").ToDouble(), Throat, 0.06);
  }
}

TEST(PoresOfSurfaces, APluggedPipeHasNone)
{
  auto map = PipeMap();
  auto* values = map->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < map->GetNumberOfPoints(); ++i)
  {
    double p[3];
    map->GetPoint(i, p);
    if (std::fabs(p[2]) < 2.0) // a plug
    {
      values->SetComponent(i, 0, 14.0 - std::hypot(p[0], p[1]));
    }
  }
  vtkNew<vtkMapSurface> surface;
  surface->SetInputData(map);
  surface->SetLevel(0.0);
  vtkNew<vtkPoreProfile> pores;
  pores->SetInputConnection(surface->GetOutputPort());
  pores->SetMinimumSpan(10.0);
  pores->Update();
  EXPECT_EQ(pores->GetPoreTable()->GetNumberOfRows(), 0);
}
