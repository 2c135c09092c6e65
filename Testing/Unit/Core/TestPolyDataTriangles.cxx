#include "Core/PolyDataTriangles.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace
{

using isthmus::Point3;
using isthmus::PolyDataTriangles;
using isthmus::SurfaceView;
using isthmus::ToTriangleMesh;
using isthmus::Triangle;
using isthmus::TriangleMesh;
using Damage = PolyDataTriangles::Damage;
using Cells = std::vector<std::vector<vtkIdType>>;

vtkSmartPointer<vtkPolyData> ToPolyData(
  const std::vector<Point3>& places, const Cells& polygons, const Cells& strips = {})
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& p : places)
  {
    points->InsertNextPoint(p.data());
  }
  const auto cellsOf = [](const Cells& lists)
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    for (const std::vector<vtkIdType>& ids : lists)
    {
      cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
    }
    return cells;
  };
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cellsOf(polygons));
  data->SetStrips(cellsOf(strips));
  return data;
}

std::vector<Triangle> ByTriangleFilter(vtkPolyData* data)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(data);
  filter->Update();
  std::vector<Triangle> triangles;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPolys(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    filter->GetOutput()->GetPolys()->GetCellAtId(i, count, ids);
    triangles.push_back({ ids[0], ids[1], ids[2] });
  }
  return triangles;
}

std::string CatchMessage(vtkPolyData* data, Damage damage)
{
  try
  {
    const PolyDataTriangles triangles(data, damage);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

const std::vector<Point3> Square{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };

}

TEST(SurfaceView, IsTheOwnersMemory)
{
  const TriangleMesh mesh{ Square, { { 0, 1, 3 }, { 0, 3, 2 } } };
  const SurfaceView view = mesh;
  EXPECT_EQ(view.Points.begin(), mesh.Points.data());
  EXPECT_EQ(view.Triangles.begin(), mesh.Triangles.data());
  EXPECT_EQ(view.NumberOfPoints(), 4);
  EXPECT_EQ(view.NumberOfTriangles(), 2);
  EXPECT_EQ(&view.Point(view.Corners(1)[1]), &mesh.Points[3]);
  EXPECT_EQ(isthmus::SurfaceArea(mesh), 1.0);
  const TriangleMesh copy = isthmus::CopyMesh(view);
  EXPECT_EQ(copy.Points, mesh.Points);
  EXPECT_EQ(copy.Triangles, mesh.Triangles);
  EXPECT_EQ(isthmus::TranslatedPoints({ 1, 2, 3 }, mesh)[3], (Point3{ 0, -1, -3 }));
}

TEST(SurfaceView, IsNoLargerThanTwoPointersAndTwoSizes)
{
  EXPECT_TRUE(std::is_trivially_copyable_v<SurfaceView>);
  EXPECT_EQ(sizeof(SurfaceView), 32U);
}

TEST(PolyDataTriangles, MatchVTKsTriangleFilter)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(0.3, 1.2), height(-0.3, 0.3);
  for (int run = 0; run < 200; ++run)
  {
    // Polygons, most of them not convex and not plane, a triangle among them, and strips.
    std::vector<Point3> points;
    Cells polygons, strips;
    for (const int corners : { 3, 4, 5, 8 })
    {
      std::vector<vtkIdType> ids;
      for (int i = 0; i < corners; ++i)
      {
        const double angle = 6.28 * i / corners, r = radius(random);
        ids.push_back(static_cast<vtkIdType>(points.size()));
        points.push_back({ r * std::cos(angle), r * std::sin(angle), height(random) });
      }
      polygons.push_back(ids);
    }
    strips = { { 0, 1, 2, 3, 4, 5 }, { 7, 8, 9 } };
    const auto data = ToPolyData(points, polygons, strips);
    const std::vector<Triangle> expected = ByTriangleFilter(data);
    for (const Damage damage : { Damage::Refused, Damage::Kept })
    {
      const TriangleMesh mesh = PolyDataTriangles(data, damage).TakeMesh();
      EXPECT_EQ(mesh.Points, points);
      EXPECT_EQ(mesh.Triangles, expected);
    }
  }
}

TEST(PolyDataTriangles, KnowTheirCells)
{
  const auto mixed = ToPolyData(Square, { { 0, 1, 3, 2 }, { 0, 1, 2 } }, { { 0, 1, 2, 3 } });
  const auto plain = ToPolyData(Square, { { 0, 1, 2 }, { 1, 3, 2 } });
  for (vtkPolyData* data : { mixed.Get(), plain.Get() })
  {
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ 0, 1 });
    data->SetLines(lines);
  }
  std::vector<vtkIdType> cells;
  const PolyDataTriangles ofMixed(mixed), ofPlain(plain);
  for (vtkIdType t = 0; t < ofMixed.View().NumberOfTriangles(); ++t)
  {
    cells.push_back(ofMixed.GetCellId(t));
  }
  EXPECT_EQ(cells, (std::vector<vtkIdType>{ 1, 1, 2, 3, 3 }));
  EXPECT_EQ(ofPlain.GetCellId(0), 1);
  EXPECT_EQ(ofPlain.GetCellId(1), 2);
}

TEST(PolyDataTriangles, RefuseOrKeepDamage)
{
  const auto lost = ToPolyData(Square, { { 0, 1, 2 }, { 0, 4, 2 } });
  EXPECT_NE(CatchMessage(lost, Damage::Refused).find("Cell 1 has the corner 4"), std::string::npos);
  EXPECT_EQ(ToTriangleMesh(lost).Triangles, (std::vector<Triangle>{ { 0, 1, 2 }, { 0, 4, 2 } }));

  std::vector<Point3> places = Square;
  places[3][1] = std::numeric_limits<double>::quiet_NaN();
  const auto unused = ToPolyData(places, { { 0, 1, 2 } });
  EXPECT_EQ(CatchMessage(unused, Damage::Refused), "");
  const auto used = ToPolyData(places, { { 0, 1, 2 }, { 1, 3, 2 } });
  EXPECT_NE(CatchMessage(used, Damage::Refused).find("Point 3"), std::string::npos);
  EXPECT_EQ(ToTriangleMesh(used).Triangles.size(), 2U);

  const auto flat = ToPolyData({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 3, 0, 0 } },
    { { 0, 1, 2 }, { 0, 1 }, { 0, 1, 2, 3 } });
  EXPECT_NE(CatchMessage(flat, Damage::Refused).find("can't be split"), std::string::npos);
  EXPECT_EQ(ToTriangleMesh(flat).Triangles, ByTriangleFilter(flat));

  // Splitting these polygons would read beyond the points.
  const auto wrong = ToPolyData(Square, { { 0, 1, 3, 9 } });
  for (const Damage damage : { Damage::Refused, Damage::Kept })
  {
    EXPECT_NE(CatchMessage(wrong, damage).find("Cell 0 has the corner 9"), std::string::npos);
  }
}

TEST(PolyDataTriangles, OfEmptyInputAreEmpty)
{
  vtkNew<vtkPolyData> empty;
  EXPECT_EQ(PolyDataTriangles(empty).View().NumberOfTriangles(), 0);
  EXPECT_TRUE(ToTriangleMesh(empty).Points.empty());
}

TEST(PolyDataMesh, RoundTripIsExact)
{
  const TriangleMesh mesh{ Square, { { 0, 1, 3 }, { 0, 3, 2 } } };
  vtkNew<vtkPolyData> data;
  SetMesh(mesh, data);
  const TriangleMesh back = ToTriangleMesh(data);
  EXPECT_EQ(back.Points, mesh.Points);
  EXPECT_EQ(back.Triangles, mesh.Triangles);
}
