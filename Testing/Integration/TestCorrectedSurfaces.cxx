// Cracks between facets, patches turned over, cavities that face the wrong way: repaired only where
// the repair is certain.

#include "Core/PolyDataTriangles.h"
#include "SharedData.h"
#include "SurfaceModels.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Surfaces/SurfaceCorrection.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceMeasures.h"
#include "Surfaces/SurfaceTopology.h"
#include "Tetrahedra/AutomaticMesher.h"
#include "TopologyFilterRun.h"

#include <vtkChokingLoops.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSurfaceMeasures.h>
#include <vtkSurfaceRemesh.h>
#include <vtkSurfaceToGrid.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

TriangleMesh Sphere(double radius, const Point3& center = { 0, 0, 0 })
{
  TriangleMesh mesh = Icosphere(6, radius);
  for (Point3& p : mesh.Points)
  {
    p = p + center;
  }
  return mesh;
}

TriangleMesh InsideOut(TriangleMesh mesh)
{
  for (Triangle& t : mesh.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

TriangleMesh Together(const std::vector<TriangleMesh>& parts)
{
  TriangleMesh all;
  for (const TriangleMesh& part : parts)
  {
    const auto first = static_cast<vtkIdType>(all.Points.size());
    all.Points.insert(all.Points.end(), part.Points.begin(), part.Points.end());
    for (const Triangle& t : part.Triangles)
    {
      all.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
  }
  return all;
}

/// Each triangle with corners of its own, displaced by up to `noise`.
TriangleMesh Facets(const TriangleMesh& mesh, double noise)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-noise, noise);
  TriangleMesh facets;
  for (const Triangle& t : mesh.Triangles)
  {
    const auto first = static_cast<vtkIdType>(facets.Points.size());
    for (const vtkIdType p : t)
    {
      facets.Points.push_back(
        mesh.Points[At(p)] + Point3{ shift(random), shift(random), shift(random) });
    }
    facets.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return facets;
}

vtkSmartPointer<vtkPolyData> ToPolyData(const TriangleMesh& mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  SetMesh(mesh, data);
  return data;
}

struct Measured
{
  double Volume;
  double Genus;
  std::string Warning;
};

Measured Measure(const TriangleMesh& mesh)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkSurfaceMeasures> filter;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetInputData(ToPolyData(mesh));
  filter->Update();
  vtkFieldData* fields = filter->GetOutput()->GetFieldData();
  return { fields->GetArray("Volume")->GetComponent(0, 0),
    fields->GetArray("Genus")->GetComponent(0, 0),
    observer->GetWarning() ? observer->GetWarningMessage() : std::string() };
}

TriangleMesh ReadOBJ(const std::filesystem::path& path)
{
  TriangleMesh mesh;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v")
    {
      Point3 p{};
      words >> p[0] >> p[1] >> p[2];
      mesh.Points.push_back(p);
    }
    else if (kind == "f")
    {
      Triangle t{};
      for (vtkIdType& corner : t)
      {
        words >> corner;
        --corner;
        words.ignore(1000, ' ');
      }
      mesh.Triangles.push_back(t);
    }
  }
  return mesh;
}

TriangleMesh ReadBinarySTL(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(file), {} };
  TriangleMesh mesh;
  for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50)
  {
    float corners[9];
    std::memcpy(corners, &bytes[at + 12], sizeof(corners));
    const auto first = static_cast<vtkIdType>(mesh.Points.size());
    for (std::size_t c = 0; c < 9; c += 3)
    {
      mesh.Points.push_back({ corners[c], corners[c + 1], corners[c + 2] });
    }
    mesh.Triangles.push_back({ first, first + 1, first + 2 });
  }
  return mesh;
}

}

TEST(CorrectedSurfaces, CracksOfEverySizeThatRoundingLeavesAreClosed)
{
  for (const double noise : { 1e-7, 1e-6, 1e-5, 1e-4 })
  {
    for (const TriangleMesh& whole : { Sphere(5.0), TriangleMesh(Torus(40, 20, 3.0, 1.0)) })
    {
      const TriangleMesh facets = Facets(whole, noise);
      SurfaceCorrection done;
      const TriangleMesh joined{ facets.Points, JoinCracks(facets, done) };
      EXPECT_EQ(joined.Triangles.size(), whole.Triangles.size()) << noise;
      EXPECT_TRUE(FindDefects(MergePoints(joined)).None()) << noise;
      EXPECT_GT(done.Tolerance, noise);
      EXPECT_LT(done.Tolerance, 200.0 * noise + 1e-5);
      EXPECT_NE(done.Message().find("merged with others within"), std::string::npos);
      EXPECT_NEAR(SignedVolume(joined), SignedVolume(whole), 100.0 * noise);
    }
  }
}

TEST(CorrectedSurfaces, HolesAndCoarseCracksStay)
{
  TriangleMesh open = Sphere(5.0);
  open.Triangles.resize(open.Triangles.size() - 4);
  SurfaceCorrection done;
  EXPECT_EQ(JoinCracks(open, done), open.Triangles);
  EXPECT_EQ(done.Joined, 0);
  EXPECT_EQ(done.Message(), "");
  const TriangleMesh coarse = Facets(Sphere(5.0), 0.05);
  JoinCracks(coarse, done);
  EXPECT_EQ(done.Joined, 0);
  // Beside a hole, cracks are closed and the hole is not.
  const TriangleMesh facets = Facets(open, 1e-6);
  const TriangleMesh joined = MergePoints({ facets.Points, JoinCracks(facets, done) });
  EXPECT_GT(done.Joined, 0);
  EXPECT_EQ(
    FindDefects(joined).BoundaryTriangles.size(), FindDefects(open).BoundaryTriangles.size());
}

TEST(CorrectedSurfaces, CornersThatCloseNoCrackStaySeparate)
{
  // Two triangles whose corners nearly meet: joining them would not reduce the number of open
  // edges.
  TriangleMesh two;
  two.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1e-7, 0, 0 }, { -1, 0, 0 },
    { 0, -1, 0 } };
  two.Triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  SurfaceCorrection done;
  EXPECT_EQ(JoinCracks(two, done), two.Triangles);
  EXPECT_EQ(done.Joined, 0);
}

TEST(CorrectedSurfaces, PatchesAreOrientedLikeTheirNeighbours)
{
  for (const TriangleMesh& right :
    { Sphere(2.0), InsideOut(Sphere(2.0)), TriangleMesh(Torus(40, 20, 3.0, 1.0)),
      Together({ Sphere(1.0), Sphere(1.0, { 5, 0, 0 }) }) })
  {
    TriangleMesh turned = right;
    for (std::size_t t = 0; t < turned.Triangles.size(); t += t % 50 < 12 ? 1 : 38)
    {
      std::swap(turned.Triangles[t][0], turned.Triangles[t][1]);
    }
    ASSERT_FALSE(FindDefects(turned).FlippedTriangles.empty());
    SurfaceCorrection done;
    turned.Triangles = OrientAlike(turned, done);
    EXPECT_TRUE(FindDefects(turned).None());
    EXPECT_NEAR(SignedVolume(turned), SignedVolume(right), 1e-9);
    EXPECT_GT(done.Turned, 10);
  }
  // A Moebius strip has no consistent orientation.
  TriangleMesh strip;
  for (vtkIdType i = 0; i < 12; ++i)
  {
    const double a = 2.0 * M_PI * static_cast<double>(i) / 12.0;
    for (const double s : { -0.3, 0.3 })
    {
      strip.Points.push_back({ (1.0 + s * std::cos(a / 2)) * std::cos(a),
        (1.0 + s * std::cos(a / 2)) * std::sin(a), s * std::sin(a / 2) });
    }
    const bool last = i == 11;
    const vtkIdType p = 2 * i, q = 2 * i + 1, r = last ? 1 : 2 * i + 2, s = last ? 0 : 2 * i + 3;
    strip.Triangles.push_back({ p, q, r });
    strip.Triangles.push_back({ q, s, r });
  }
  SurfaceCorrection done;
  EXPECT_EQ(OrientAlike(strip, done), strip.Triangles);
  EXPECT_EQ(done.Turned, 0);
}

TEST(CorrectedSurfaces, CavitiesCountAgainstTheBodyHoweverTheyFace)
{
  const double unit = SignedVolume(Sphere(1.0));
  const auto ball = [&unit](double r) { return r * r * r * unit; };
  const TriangleMesh outer = Sphere(10.0);
  const TriangleMesh cavity = Sphere(4.0, { 3, 0, 0 });
  const TriangleMesh other = Sphere(2.0, { -5, 0, 0 });
  const TriangleMesh core = Sphere(1.0, { 3, 0, 0 });
  const double right = ball(10) - ball(4) - ball(2) + ball(1);
  for (int turned = 0; turned < 16; ++turned)
  {
    const auto part = [turned](const TriangleMesh& mesh, int bit)
    { return (turned >> bit & 1) == 1 ? InsideOut(mesh) : mesh; };
    const Measured measured =
      Measure(Together({ part(outer, 0), part(cavity, 1), part(other, 2), part(core, 3) }));
    // The outermost shell decides whether the whole is inside out.
    EXPECT_NEAR(measured.Volume, (turned & 1) == 1 ? -right : right, 1e-6 * right) << turned;
    EXPECT_EQ(measured.Warning.empty(), turned == 6 || turned == 9) << turned;
  }
  // Beside each other neither is a cavity; crossing, the volume is refused (ShellCrossings.h).
  EXPECT_NEAR(
    Measure(Together({ outer, Sphere(2.0, { 20, 0, 0 }) })).Volume, ball(10) + ball(2), 1e-6);
  const Measured crossing = Measure(Together({ outer, Sphere(2.0, { 9, 0, 0 }) }));
  EXPECT_TRUE(std::isnan(crossing.Volume));
  EXPECT_NE(crossing.Warning.find("cross at ("), std::string::npos) << crossing.Warning;
  EXPECT_NEAR(Measure(Together({ outer, InsideOut(Sphere(2.0, { 20, 0, 0 })) })).Volume,
    ball(10) + ball(2), 1e-6);
  EXPECT_EQ(Measure(InsideOut(outer)).Warning, "");
}

TEST(CorrectedSurfaces, ReportedFilesHaveTheVolumeOfTheirShape)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/s02_flipped_patch.obj");
  const auto folder = SharedDataFolder() / "reports";
  // A torus of 72 x 16 quadrilaterals, radii 10 and 3; spheres of 10 and 4 around one center.
  const double torus = 2.0 * M_PI * M_PI * 10.0 * 9.0;
  const Measured flipped = Measure(ReadOBJ(folder / "s02_flipped_patch.obj"));
  EXPECT_NEAR(flipped.Volume, torus, 0.02 * torus);
  EXPECT_EQ(flipped.Genus, 1);
  EXPECT_NE(flipped.Warning.find("30 triangles were flipped"), std::string::npos)
    << flipped.Warning;
  const Measured cracks = Measure(ReadBinarySTL(folder / "s04_jitter_cracks.stl"));
  EXPECT_NEAR(cracks.Volume, flipped.Volume, 1e-6 * torus);
  EXPECT_EQ(cracks.Genus, 1);
  const Measured cavity = Measure(ReadOBJ(folder / "s09_cavity_same_orientation.obj"));
  const double shell = 4.0 / 3.0 * M_PI * (1000.0 - 64.0);
  EXPECT_NEAR(cavity.Volume, shell, 0.02 * shell);
}

// The winding number, by which isosurface stuffing decides, is 2 in a cavity that faces the wrong
// way.
TEST(CorrectedSurfaces, StuffedSolidsHaveTheirCavities)
{
  for (const bool turned : { false, true })
  {
    const TriangleMesh cavity = Sphere(5.0);
    const TriangleMesh shell = Together({ Sphere(10.0), turned ? InsideOut(cavity) : cavity });
    SolidStuffingParameters parameters;
    parameters.CellSize = 1.0;
    const TetrahedralMesh mesh = StuffSolid(shell, parameters);
    double volume = 0.0;
    for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
    {
      const auto& t = mesh.Tetrahedra[i];
      const Point3& a = mesh.Points[At(t[0])];
      volume += mesh.Regions[i] == 0
        ? 0.0
        : std::abs(Dot(mesh.Points[At(t[1])] - a,
            Cross(mesh.Points[At(t[2])] - a, mesh.Points[At(t[3])] - a))) /
          6.0;
    }
    const double right = SignedVolume(Sphere(10.0)) - SignedVolume(cavity);
    EXPECT_NEAR(volume, right, 0.02 * right) << turned;
  }
}

TEST(CorrectedSurfaces, FiltersTakeFacetsWithCracks)
{
  const TriangleMesh facets = Facets(Torus(40, 20, 1.0, 0.3), 1e-6);
  for (const bool capHoles : { false, true })
  {
    TopologyFilterRun<vtkChokingLoops> run(
      ToPolyData(facets), [capHoles](vtkChokingLoops* filter) { filter->SetCapHoles(capHoles); });
    EXPECT_EQ(run.Surface(0)->GetNumberOfCells(), 2) << run.Messages();
    EXPECT_NE(run.Messages().find("merged with others within"), std::string::npos)
      << run.Messages();
  }
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkSurfaceToGrid> grid;
  grid->AddObserver(vtkCommand::WarningEvent, observer);
  grid->AddObserver(vtkCommand::ErrorEvent, observer);
  grid->SetInputData(0, ToPolyData(facets));
  grid->Update();
  EXPECT_FALSE(observer->GetError());
  EXPECT_TRUE(observer->GetWarning());
  EXPECT_GT(vtkImageData::SafeDownCast(grid->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
  vtkNew<vtkSurfaceRemesh> remesh;
  remesh->AddObserver(vtkCommand::WarningEvent, observer);
  remesh->SetInputData(ToPolyData(facets));
  remesh->Update();
  EXPECT_TRUE(FindDefects(ToTriangleMesh(remesh->GetOutput())).None());
  TriangleMesh patch = Torus(40, 20, 1.0, 0.3);
  std::swap(patch.Triangles[7][0], patch.Triangles[7][1]);
  remesh->SetInputData(ToPolyData(patch));
  remesh->Update();
  EXPECT_GT(remesh->GetOutput()->GetNumberOfCells(), 100);
  EXPECT_TRUE(FindDefects(ToTriangleMesh(remesh->GetOutput())).None());
}

// Inside and outside of a surface are regions of space; which way a cavity faces does not matter.
TEST(CorrectedSurfaces, LoopsDoNotDependOnHowACavityFaces)
{
  const TriangleMesh outer = Sphere(3.0);
  const TriangleMesh cavity = Torus(40, 20, 1.0, 0.3);
  TopologyFilterRun<vtkChokingLoops> same(ToPolyData(Together({ outer, cavity })));
  TopologyFilterRun<vtkChokingLoops> opposite(ToPolyData(Together({ outer, InsideOut(cavity) })));
  EXPECT_EQ(same.Surface(0)->GetNumberOfCells(), opposite.Surface(0)->GetNumberOfCells());
  EXPECT_EQ(same.Surface(0)->GetNumberOfPoints(), opposite.Surface(0)->GetNumberOfPoints());
  EXPECT_GT(same.Surface(0)->GetNumberOfCells(), 1);
}
