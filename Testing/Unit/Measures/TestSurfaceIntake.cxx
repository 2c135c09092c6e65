#include "SurfaceIntake.h"
#include "vtkSurfaceMeasures.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

using namespace isthmus;

namespace
{

/// A tetrahedron, each triangle with points of its own, as in an STL file.
TriangleMesh Soup()
{
  const Point3 p[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const int corners[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  TriangleMesh mesh;
  for (const auto& t : corners)
  {
    const auto first = static_cast<std::int64_t>(mesh.Points.size());
    mesh.Triangles.push_back({ first, first + 1, first + 2 });
    for (const int corner : t)
    {
      mesh.Points.push_back(p[corner]);
    }
  }
  return mesh;
}

}

TEST(SurfaceIntake, PointsThatCoincideAreOne)
{
  TriangleMesh soup = Soup();
  soup.Points.push_back({ 9, 9, 9 }); // of no triangle
  EXPECT_FALSE(FindDefects(soup).None());
  const TriangleMesh merged = MergePoints(soup);
  EXPECT_EQ(merged.Points.size(), 4U);
  EXPECT_EQ(merged.Triangles.size(), 4U);
  EXPECT_TRUE(FindDefects(merged).None()) << FindDefects(merged).Sentence();
}

TEST(SurfaceIntake, WhatCollapsesGoesAndWhatWasWrongStays)
{
  TriangleMesh soup = Soup();
  soup.Points.push_back({ 0, 0, 0 });
  soup.Triangles.push_back({ 0, 12, 1 }); // the places of 0 and 12 are one
  EXPECT_EQ(MergePoints(soup).Triangles.size(), 4U);
  soup.Triangles.push_back({ 0, 0, 1 });
  EXPECT_EQ(MergePoints(soup).Triangles.size(), 5U);
  soup.Triangles.push_back({ 0, 99, 1 });
  EXPECT_THROW(MergePoints(soup), std::invalid_argument);
}

TEST(SurfaceIntake, NamesALevelThatLeavesTheMapAndNothingElse)
{
  TriangleMesh open = MergePoints(Soup());
  open.Triangles.erase(open.Triangles.begin()); // that on z = 0, a face of the box
  EXPECT_NE(WhyOpen(open, FindDefects(open)).find("leaves the map"), std::string::npos);
  TriangleMesh torn = MergePoints(Soup());
  torn.Triangles.erase(torn.Triangles.begin() + 2); // the slanted one
  // Its edges lie on faces of the box, those of a tetrahedron do: so two tetrahedra in one box.
  for (Point3 p : MergePoints(Soup()).Points)
  {
    torn.Points.push_back(p + Point3{ 5, 5, 5 });
    torn.Points.push_back(p + Point3{ -5, -5, -5 });
  }
  EXPECT_EQ(WhyOpen(torn, FindDefects(torn)), "");
  EXPECT_EQ(WhyOpen(MergePoints(Soup()), FindDefects(MergePoints(Soup()))), "");
}

TEST(SurfaceIntake, SurfaceMeasuresOfASoupAreThoseOfTheSurface)
{
  const TriangleMesh soup = Soup();
  vtkNew<vtkPolyData> surface;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Point3& p : soup.Points)
  {
    points->InsertNextPoint(p.data());
  }
  for (const Triangle& t : soup.Triangles)
  {
    cells->InsertNextCell({ t[0], t[1], t[2] });
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
  vtkNew<vtkSurfaceMeasures> measures;
  measures->SetInputData(surface);
  measures->Update();
  vtkFieldData* fields = measures->GetOutputDataObject(0)->GetFieldData();
  EXPECT_EQ(fields->GetArray("Components")->GetComponent(0, 0), 1.0);
  EXPECT_EQ(fields->GetArray("OpenEdges")->GetComponent(0, 0), 0.0);
  EXPECT_NEAR(fields->GetArray("Volume")->GetComponent(0, 0), 1.0 / 6.0, 1e-15);
}
