#include "Surfaces/SurfaceCleaning.h"
#include "vtkSurfaceMeasures.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <limits>

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

TEST(SurfaceCleaning, PointsThatCoincideAreOne)
{
  TriangleMesh soup = Soup();
  soup.Points.push_back({ 9, 9, 9 }); // of no triangle
  EXPECT_FALSE(FindDefects(soup).None());
  const TriangleMesh merged = MergePoints(soup);
  EXPECT_EQ(merged.Points.size(), 4U);
  EXPECT_EQ(merged.Triangles.size(), 4U);
  EXPECT_TRUE(FindDefects(merged).None()) << FindDefects(merged).Message();
}

TEST(SurfaceCleaning, CollapsedTrianglesAreRemovedAndDefectsStay)
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

TEST(SurfaceCleaning, ReportsOnlyALevelThatLeavesTheMap)
{
  TriangleMesh open = MergePoints(Soup());
  open.Triangles.erase(open.Triangles.begin()); // that on z = 0, a face of the box
  EXPECT_NE(
    DescribeOpenBoundary(open, FindDefects(open)).find("leaves the map"), std::string::npos);
  TriangleMesh torn = MergePoints(Soup());
  torn.Triangles.erase(torn.Triangles.begin() + 2); // the slanted one
  // Its edges lie on faces of the box, like those of a tetrahedron: so two tetrahedra in one box.
  for (Point3 p : MergePoints(Soup()).Points)
  {
    torn.Points.push_back(p + Point3{ 5, 5, 5 });
    torn.Points.push_back(p + Point3{ -5, -5, -5 });
  }
  EXPECT_EQ(DescribeOpenBoundary(torn, FindDefects(torn)), "");
  EXPECT_EQ(DescribeOpenBoundary(MergePoints(Soup()), FindDefects(MergePoints(Soup()))), "");
}

TEST(SurfaceCleaning, SurfaceMeasuresOfASoupMatchTheSurface)
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

namespace
{

/// An octahedron with a triangle without area at the side 0-4: point 6 lies on it, and the triangle
/// behind does not contain it.
TriangleMesh OctahedronWithFlat()
{
  TriangleMesh mesh;
  mesh.Points = { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 },
    { 0.5, 0, 0.5 } };
  mesh.Triangles = { { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 }, { 1, 0, 5 }, { 2, 1, 5 }, { 3, 2, 5 },
    { 0, 3, 5 }, { 0, 1, 6 }, { 6, 1, 4 }, { 0, 6, 4 } };
  return mesh;
}

double ComputeVolume(const TriangleMesh& mesh)
{
  double six = 0.0;
  for (const Triangle& t : mesh.Triangles)
  {
    const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
    six += Dot(at(0), Cross(at(1), at(2)));
  }
  return six / 6.0;
}

}

TEST(SurfaceCleaning, CleanSurfacesAreUnchanged)
{
  const TriangleMesh clean = MergePoints(Soup());
  const CleanedSurface taken = CleanSurface(clean);
  EXPECT_EQ(taken.Mesh.Points, clean.Points);
  EXPECT_EQ(taken.Mesh.Triangles, clean.Triangles);
  EXPECT_EQ(taken.OriginalPoints, (std::vector<std::int64_t>{ 0, 1, 2, 3 }));
}

TEST(SurfaceCleaning, OriginalPointsLieWhereThePointsDo)
{
  const TriangleMesh soup = Soup();
  const CleanedSurface taken = CleanSurface(soup);
  ASSERT_EQ(taken.OriginalPoints.size(), taken.Mesh.Points.size());
  for (std::size_t i = 0; i < taken.OriginalPoints.size(); ++i)
  {
    EXPECT_EQ(taken.Mesh.Points[i], soup.Points[static_cast<std::size_t>(taken.OriginalPoints[i])]);
  }
}

TEST(SurfaceCleaning, AFlatTriangleIsFlippedInPlace)
{
  const TriangleMesh flat = OctahedronWithFlat();
  ASSERT_EQ(FindDefects(flat).DegenerateTriangles.size(), 1U);
  const CleanedSurface taken = CleanSurface(flat);
  EXPECT_TRUE(FindDefects(taken.Mesh).None()) << FindDefects(taken.Mesh).Message();
  EXPECT_EQ(taken.Mesh.Triangles.size(), flat.Triangles.size());
  EXPECT_DOUBLE_EQ(ComputeVolume(taken.Mesh), 4.0 / 3.0);
}

TEST(SurfaceCleaning, StackedFlatTrianglesAreRemovedLayerByLayer)
{
  // Three points on the edge 0-4, each on an edge of a flat triangle of the previous layer.
  TriangleMesh mesh = OctahedronWithFlat();
  mesh.Points.push_back({ 0.75, 0, 0.25 });
  mesh.Points.push_back({ 0.25, 0, 0.75 });
  mesh.Triangles[7] = { 0, 1, 7 };
  mesh.Triangles[8] = { 6, 1, 8 };
  mesh.Triangles.insert(
    mesh.Triangles.end(), { { 7, 1, 6 }, { 8, 1, 4 }, { 0, 7, 6 }, { 6, 8, 4 } });
  ASSERT_EQ(FindDefects(mesh).DegenerateTriangles.size(), 3U);
  const CleanedSurface taken = CleanSurface(mesh);
  EXPECT_TRUE(FindDefects(taken.Mesh).None()) << FindDefects(taken.Mesh).Message();
  EXPECT_DOUBLE_EQ(ComputeVolume(taken.Mesh), 4.0 / 3.0);
}

TEST(SurfaceCleaning, AFlatTriangleAtABorderIsDropped)
{
  TriangleMesh mesh = OctahedronWithFlat();
  mesh.Triangles.erase(mesh.Triangles.begin() + 2); // the triangle behind the flat one: a hole
  const CleanedSurface taken = CleanSurface(mesh);
  const SurfaceDefects defects = FindDefects(taken.Mesh);
  EXPECT_TRUE(defects.DegenerateTriangles.empty());
  EXPECT_EQ(taken.Mesh.Triangles.size(), mesh.Triangles.size() - 1);
  EXPECT_FALSE(defects.BoundaryTriangles.empty()); // openings are reported, not closed
}

TEST(SurfaceCleaning, RepeatedCornersAreRemovedAndInvalidIdsStay)
{
  TriangleMesh mesh = OctahedronWithFlat();
  mesh.Triangles.push_back({ 3, 3, 0 });
  EXPECT_TRUE(FindDefects(CleanSurface(mesh).Mesh).None());
  mesh.Triangles.push_back({ 3, 99, 0 });
  EXPECT_EQ(CleanSurface(mesh).Mesh.Triangles, mesh.Triangles);
  mesh.Triangles.pop_back();
  mesh.Points[2][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(CleanSurface(mesh).Mesh.Triangles, mesh.Triangles);
}
