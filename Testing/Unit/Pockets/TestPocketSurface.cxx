// Pockets weighted by a surface: means and ranks that are known; the messages of binding sites
// about them.

#include "Core/Geometry.h"
#include "Pockets/MolecularPockets.h"
#include "Pockets/PocketSurface.h"
#include "vtkBindingSites.h"
#include "vtkMolecularPockets.h"

#include <vtkAppendPolyData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace isthmus;

namespace
{

constexpr double Apart = 40.0;

/// Two hollow balls of atoms, the first the larger: two voids.
std::vector<Ball> TwoShells()
{
  std::vector<Ball> atoms;
  for (int shell = 0; shell < 2; ++shell)
  {
    const double radius = shell == 0 ? 7.0 : 6.5;
    for (int i = 0; i < 260; ++i)
    {
      const double z = 1.0 - (2.0 * i + 1.0) / 260;
      const double angle = Pi * (1.0 + std::sqrt(5.0)) * i;
      const double rho = radius * std::sqrt(1.0 - z * z);
      atoms.push_back(
        { { Apart * shell + rho * std::cos(angle), rho * std::sin(angle), radius * z }, 1.7 });
    }
  }
  return atoms;
}

vtkSmartPointer<vtkPolyData> Atoms(const std::vector<Ball>& balls)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  for (const Ball& ball : balls)
  {
    points->InsertNextPoint(ball.Center.data());
    radii->InsertNextValue(ball.Radius);
  }
  data->SetPoints(points);
  data->GetPointData()->AddArray(radii);
  return data;
}

/// A sphere in each void, with one value each of polarized curvature and potential.
vtkSmartPointer<vtkPolyData> Surface(
  const std::array<double, 2>& polarized, const std::array<double, 2>& potential)
{
  vtkNew<vtkAppendPolyData> both;
  for (std::size_t shell = 0; shell < 2; ++shell)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(Apart * static_cast<double>(shell), 0.0, 0.0);
    sphere->SetRadius(3.0);
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(13);
    sphere->Update();
    vtkPolyData* surface = sphere->GetOutput();
    const auto add = [&](const char* name, double value)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName(name);
      array->SetNumberOfValues(surface->GetNumberOfPoints());
      array->FillValue(value);
      surface->GetPointData()->AddArray(array);
    };
    add("PolarizedCurvature", polarized[shell]);
    add("Potential", potential[shell]);
    both->AddInputData(surface);
  }
  both->Update();
  return both->GetOutput();
}

struct Row
{
  double Score, X, MeanPolarized, MeanPotential;
};

std::vector<Row> Pockets(vtkPolyData* surface, bool use = true)
{
  vtkNew<vtkMolecularPockets> filter;
  filter->SetInputData(Atoms(TwoShells()));
  filter->SetSurfaceData(surface);
  filter->SetUsePolarizedCurvature(use);
  filter->SetMinimumVolume(20.0);
  filter->Update();
  vtkTable* table = filter->GetPocketTable();
  std::vector<Row> rows;
  for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
  {
    const auto value = [&](const char* name) { return table->GetValueByName(i, name).ToDouble(); };
    rows.push_back(
      { value("Score"), value("CenterX"), value("MeanPolarized"), value("MeanPotential") });
  }
  return rows;
}

/// The error or warning of a filter.
template <typename Filter>
std::string MessagesBy(Filter* filter)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  for (vtkObject* object : std::initializer_list<vtkObject*>{ filter, filter->GetExecutive() })
  {
    object->AddObserver(vtkCommand::ErrorEvent, observer);
    object->AddObserver(vtkCommand::WarningEvent, observer);
  }
  filter->Update();
  return observer->GetErrorMessage() + observer->GetWarningMessage();
}

}

TEST(PocketSurface, MeansAreThoseOfTheSurfaceAndEnterTheScore)
{
  const auto plain = Pockets(nullptr);
  ASSERT_EQ(plain.size(), 2u);
  EXPECT_NEAR(plain[0].X, 0.0, 0.1); // the larger one
  EXPECT_TRUE(std::isnan(plain[0].MeanPolarized) && std::isnan(plain[0].MeanPotential));
  // Both spheres have the same area, so that the mean over the whole surface is that of two values.
  const auto weighed = Pockets(Surface({ -1.0, 9.0 }, { 2.5, -4.0 }));
  ASSERT_EQ(weighed.size(), 2u);
  EXPECT_NEAR(weighed[0].X, Apart, 0.1); // then the other one is first
  EXPECT_NEAR(weighed[0].MeanPolarized, 9.0, 1e-9);
  EXPECT_NEAR(weighed[1].MeanPolarized, 1.0, 1e-9); // of the absolute value
  EXPECT_NEAR(weighed[0].MeanPotential, -4.0, 1e-9);
  EXPECT_NEAR(weighed[1].MeanPotential, 2.5, 1e-9);
  EXPECT_NEAR(weighed[0].Score, plain[1].Score * std::sqrt(9.0 / 5.0), 1e-6 * plain[1].Score);
  EXPECT_NEAR(weighed[1].Score, plain[0].Score * std::sqrt(1.0 / 5.0), 1e-6 * plain[0].Score);
  const auto off = Pockets(Surface({ -1.0, 9.0 }, { 2.5, -4.0 }), false);
  EXPECT_EQ(off[0].Score, plain[0].Score);
}

TEST(PocketSurface, PlacesWithoutAValueDoNotCount)
{
  const auto plain = Pockets(nullptr);
  const auto half = Pockets(Surface({ 2.0, std::nan("") }, { 3.0, std::nan("") }));
  ASSERT_EQ(half.size(), 2u);
  EXPECT_NEAR(half[0].MeanPolarized, 2.0, 1e-9);
  EXPECT_NEAR(half[0].Score, plain[0].Score, 1e-9 * plain[0].Score); // 2 over the mean, 2
  EXPECT_TRUE(std::isnan(half[1].MeanPolarized) && std::isnan(half[1].MeanPotential));
  EXPECT_EQ(half[1].Score, plain[1].Score);
  const auto nowhere = Pockets(Surface({ 0.0, 0.0 }, { 0.0, 0.0 }));
  EXPECT_EQ(nowhere[0].Score, plain[0].Score); // no values that distinguish them
}

TEST(PocketSurface, ASurfaceWithoutPolarizedCurvatureIsReported)
{
  auto surface = Surface({ 1.0, 1.0 }, { 1.0, 1.0 });
  surface->GetPointData()->RemoveArray("PolarizedCurvature");
  vtkNew<vtkMolecularPockets> filter;
  filter->SetInputData(Atoms(TwoShells()));
  filter->SetSurfaceData(surface);
  const std::string said = MessagesBy(filter.Get());
  EXPECT_NE(said.find("PolarizedCurvature"), std::string::npos) << said;
  EXPECT_EQ(filter->GetPocketTable()->GetNumberOfRows(), 0);
  // A potential is not needed: its mean is then unknown.
  surface = Surface({ 1.0, 1.0 }, { 1.0, 1.0 });
  surface->GetPointData()->RemoveArray("Potential");
  EXPECT_TRUE(std::isnan(Pockets(surface).at(0).MeanPotential));
}

TEST(PocketSurface, BindingSitesReportTheirKind)
{
  auto surface = Surface({ 1.0, 3.0 }, { -1.0, 1.0 });
  vtkNew<vtkUnsignedCharArray> classes;
  classes->SetName("SiteClass");
  classes->SetNumberOfValues(surface->GetNumberOfPoints());
  classes->FillValue(4);
  surface->GetPointData()->AddArray(classes);
  const auto notes = [](vtkBindingSites* sites)
  {
    auto* array = vtkStringArray::SafeDownCast(
      sites->GetSiteTable()->GetFieldData()->GetAbstractArray("Notes"));
    return array && array->GetNumberOfValues() > 0
      ? std::string(array->GetValue(array->GetNumberOfValues() - 1))
      : std::string();
  };
  vtkNew<vtkBindingSites> sites;
  sites->SetInputData(surface);
  sites->SetThreshold(2.0);
  EXPECT_EQ(MessagesBy(sites.Get()), "");
  EXPECT_EQ(notes(sites), "Sites are patches of the surface.");
  // A flat molecule has no pocket: this is reported, with advice.
  std::vector<Ball> flat;
  for (int i = 0; i < 25; ++i)
  {
    flat.push_back({ { 2.0 * (i % 5), 2.0 * (i / 5), 0.0 }, 1.7 });
  }
  sites->SetAtomsData(Atoms(flat));
  const std::string said = MessagesBy(sites.Get());
  EXPECT_NE(said.find("no pocket"), std::string::npos) << said;
  EXPECT_NE(said.find("Use Pockets off"), std::string::npos) << said;
  EXPECT_EQ(sites->GetSiteTable()->GetNumberOfRows(), 0);
  EXPECT_EQ(notes(sites), "Sites are pockets.");
}
