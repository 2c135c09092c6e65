// vtkMolecularFlowSurface as a user has it: surfaces, image, table, bad input, progress and stop.

#include "vtkMolecularFlowSurface.h"

#include "FlowCases.h"
#include "SharedData.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkMolecule.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkTriangle.h>
#include <vtkUnsignedShortArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

vtkSmartPointer<vtkMolecularFlowSurface> FilterOf(vtkDataObject* atoms)
{
  auto filter = vtkSmartPointer<vtkMolecularFlowSurface>::New();
  filter->SetInputDataObject(atoms);
  return filter;
}

double LastOf(vtkTable* table, const char* column)
{
  return table->GetValueByName(table->GetNumberOfRows() - 1, column).ToDouble();
}

/// Nodes on the image's border have to be outside, or the surface would be open.
double LowestOnBorder(vtkImageData* image)
{
  const int* n = image->GetDimensions();
  vtkDataArray* values = image->GetPointData()->GetArray("SignedDistance");
  double lowest = 1e9;
  for (vtkIdType node = 0; node < image->GetNumberOfPoints(); ++node)
  {
    const auto i = static_cast<int>(node % n[0]);
    const auto j = static_cast<int>(node / n[0] % n[1]);
    const auto k = static_cast<int>(node / n[0] / n[1]);
    if (i == 0 || j == 0 || k == 0 || i == n[0] - 1 || j == n[1] - 1 || k == n[2] - 1)
    {
      lowest = std::min(lowest, values->GetComponent(node, 0));
    }
  }
  return lowest;
}

struct Errors
{
  explicit Errors(vtkMolecularFlowSurface* filter)
    : Filter(filter)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, this->Said);
    filter->AddObserver(vtkCommand::WarningEvent, this->Said);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Pipeline);
  }
  std::string Of(vtkDataObject* atoms)
  {
    this->Said->Clear();
    this->Filter->SetInputDataObject(atoms);
    this->Filter->Modified();
    this->Filter->Update();
    return this->Said->GetErrorMessage() + this->Said->GetWarningMessage();
  }
  bool IsEmpty() const
  {
    return this->Filter->GetOutput()->GetNumberOfPoints() == 0 &&
      this->Filter->GetImage()->GetNumberOfPoints() == 0 &&
      this->Filter->GetHistory()->GetNumberOfRows() == 0;
  }

  vtkMolecularFlowSurface* Filter;
  vtkNew<vtkTest::ErrorObserver> Said;
  vtkNew<vtkTest::ErrorObserver> Pipeline;
};

}

TEST(MolecularFlowSurface, CatenoidBetweenTwoBallsIsSecondOrder)
{
  const Catenoid exact;
  std::array<double, 3> area{};
  std::array<double, 3> volume{};
  const std::array<double, 3> spacings{ 0.5, 0.25, 0.125 };
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto filter = FilterOf(AtomsOf(exact.Balls()));
    filter->SetSteady(true);
    filter->SetSpacing(spacings[i]);
    filter->Update();
    const SurfaceMeasure found = MeasuresOf(filter->GetOutput()).Whole;
    EXPECT_TRUE(found.IsClosed());
    EXPECT_EQ(found.Genus, 0);
    area[i] = found.Area / exact.Area() - 1.0;
    volume[i] = found.Volume / exact.Volume() - 1.0;
    std::cout << "h " << spacings[i] << ": area " << area[i] << ", volume " << volume[i] << "\n";
  }
  EXPECT_LT(std::abs(area[1]), 5e-3);
  EXPECT_GT(0.5 * std::log2(area[0] / area[2]), 1.8);
  EXPECT_GT(0.5 * std::log2(volume[0] / volume[2]), 1.8);
}

TEST(MolecularFlowSurface, NeckBreaksWhereNoCatenoidIs)
{
  for (const double spacing : { 0.5, 0.25 })
  {
    for (const double distance : { 1.195, 1.215 })
    {
      const auto filter = FilterOf(AtomsOf(Catenoid{ 2.0, distance }.Balls()));
      filter->SetSteady(true);
      filter->SetSpacing(spacing);
      filter->Update();
      EXPECT_EQ(MeasuresOf(filter->GetOutput()).Components.size(), distance < 1.2 ? 1u : 2u)
        << spacing << " " << distance;
    }
  }
}

TEST(MolecularFlowSurface, OutputsFitEachOther)
{
  const auto filter = FilterOf(AtomsOf(RandomBalls(60, 12.0)));
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  const SurfaceMeasure whole = MeasuresOf(surface).Whole;
  EXPECT_TRUE(whole.IsClosed());
  EXPECT_EQ(whole.IrregularPoints, 0);
  EXPECT_GT(whole.Volume, 0.0); // triangles face outwards
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  double ids[3];
  vtkIdType along = 0;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkTriangle* triangle = vtkTriangle::SafeDownCast(surface->GetCell(cell));
    ASSERT_NE(triangle, nullptr);
    vtkTriangle::ComputeNormal(
      surface->GetPoints(), 3, triangle->GetPointIds()->GetPointer(0), ids);
    along += vtkMath::Dot(ids, normals->GetTuple(triangle->GetPointId(0))) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(along, surface->GetNumberOfCells() * 99 / 100);

  vtkImageData* image = filter->GetImage();
  vtkDataArray* distance = image->GetPointData()->GetArray("SignedDistance");
  vtkDataArray* s = image->GetPointData()->GetArray("S");
  ASSERT_NE(distance, nullptr);
  ASSERT_NE(s, nullptr);
  for (vtkIdType node = 0; node < image->GetNumberOfPoints(); ++node)
  {
    const double expected =
      std::clamp(0.5 - distance->GetComponent(node, 0) / (2.4 * 0.5), 0.0, 1.0);
    ASSERT_NEAR(s->GetComponent(node, 0), expected, 1e-5);
  }
  EXPECT_GT(LowestOnBorder(image), 0.9);
  vtkTable* history = filter->GetHistory();
  EXPECT_EQ(history->GetValueByName(0, "Time").ToDouble(), 0.0);
  EXPECT_NEAR(LastOf(history, "Time"), 2.5, 1e-9);
  EXPECT_NEAR(LastOf(history, "Area") / whole.Area, 1.0, 5e-3);
  EXPECT_NEAR(LastOf(history, "Volume") / whole.Volume, 1.0, 5e-3);
  EXPECT_NEAR(LastOf(history, "Energy"), 0.0700 * LastOf(history, "Area"), 1e-9);
}

TEST(MolecularFlowSurface, AtomsStayInside)
{
  const std::vector<Ball> balls = RandomBalls(60, 12.0);
  for (const int preset : { vtkMolecularFlowSurface::Fine, vtkMolecularFlowSurface::Coarse,
         vtkMolecularFlowSurface::Hull, vtkMolecularFlowSurface::Channel })
  {
    const auto filter = FilterOf(AtomsOf(balls));
    filter->SetPreset(preset);
    filter->Update();
    vtkImageData* image = filter->GetImage();
    vtkDataArray* distance = image->GetPointData()->GetArray("SignedDistance");
    for (vtkIdType node = 0; node < image->GetNumberOfPoints(); ++node)
    {
      double at[3];
      image->GetPoint(node, at);
      double nearest = 2.25; // where SignedDistance is cut
      for (const Ball& ball : balls)
      {
        nearest = std::min(nearest,
          std::sqrt(vtkMath::Distance2BetweenPoints(at, ball.Centre.data())) - ball.Radius);
      }
      ASSERT_LT(distance->GetComponent(node, 0), nearest + 2e-3) << preset;
    }
    EXPECT_GT(LowestOnBorder(image), 0.9);
  }
}

TEST(MolecularFlowSurface, IsoValueIsAnOffset)
{
  const auto filter = FilterOf(AtomsOf({ { { 0.1, 0.2, 0.3 }, 4.0 } }));
  filter->SetSteady(true);
  for (const double level : { 0.2, 0.5, 0.8 })
  {
    filter->SetIsoValue(level);
    filter->Update();
    const double radius =
      std::sqrt(MeasuresOf(filter->GetOutput()).Whole.Area / (4.0 * vtkMath::Pi()));
    EXPECT_NEAR(radius, 4.0 + 0.6 * (1.0 - 2.0 * level), 0.02) << level;
  }
}

TEST(MolecularFlowSurface, BorderIsKeptFreeWithoutPadding)
{
  const auto filter = FilterOf(AtomsOf(RandomBalls(20, 8.0)));
  filter->SetPadding(0.0);
  for (const double spacing : { 0.3, 0.7, 1.0 })
  {
    filter->SetSpacing(spacing);
    filter->Update();
    EXPECT_TRUE(MeasuresOf(filter->GetOutput()).Whole.IsClosed());
    EXPECT_GT(LowestOnBorder(filter->GetImage()), 1.5 * spacing);
  }
}

TEST(MolecularFlowSurface, DelaunayQualityIsTheSameSurface)
{
  const auto filter = FilterOf(AtomsOf(Catenoid().Balls()));
  filter->SetSteady(true);
  filter->SetSpacing(0.25);
  filter->Update();
  const SurfaceMeasure plain = MeasuresOf(filter->GetOutput()).Whole;
  filter->SetDelaunayQuality(true);
  filter->Update();
  const SurfaceMeasure fair = MeasuresOf(filter->GetOutput()).Whole;
  EXPECT_TRUE(fair.IsClosed());
  EXPECT_EQ(fair.Genus, 0);
  EXPECT_NEAR(fair.Area / plain.Area, 1.0, 0.02);
  EXPECT_GT(fair.Volume, 0.0);
}

TEST(MolecularFlowSurface, RadiiGoByElementWhereThereAreNone)
{
  vtkNew<vtkMolecule> molecule;
  molecule->AppendAtom(6, 0.0, 0.0, 0.0);
  molecule->AppendAtom(8, 1.2, 0.0, 0.0);
  const auto filter = FilterOf(molecule);
  filter->SetSteady(true);
  filter->Update();
  const double byMolecule = MeasuresOf(filter->GetOutput()).Whole.Area;
  EXPECT_GT(byMolecule, 4.0 * vtkMath::Pi() * 1.7 * 1.7);
  const auto points = AtomsOf({ { { 0.0, 0.0, 0.0 }, 1.70 }, { { 1.2, 0.0, 0.0 }, 1.52 } });
  filter->SetInputDataObject(points);
  filter->Update();
  EXPECT_NEAR(MeasuresOf(filter->GetOutput()).Whole.Area, byMolecule, 1e-4);
  points->GetPointData()->RemoveArray("Radius");
  vtkNew<vtkUnsignedShortArray> elements;
  elements->SetName("Element");
  elements->InsertNextValue(6);
  elements->InsertNextValue(8);
  points->GetPointData()->AddArray(elements);
  filter->Modified();
  filter->Update();
  EXPECT_NEAR(MeasuresOf(filter->GetOutput()).Whole.Area, byMolecule, 1e-4);
}

TEST(MolecularFlowSurface, InputStaysAsItWasAndFloatsWork)
{
  const auto doubles = AtomsOf(Catenoid().Balls());
  const auto floats = AtomsOf(Catenoid().Balls(), VTK_FLOAT);
  const auto before = doubles->GetMTime();
  const auto filter = FilterOf(doubles);
  filter->Update();
  EXPECT_EQ(doubles->GetMTime(), before);
  const double area = MeasuresOf(filter->GetOutput()).Whole.Area;
  filter->SetInputDataObject(floats);
  filter->Update();
  EXPECT_NEAR(MeasuresOf(filter->GetOutput()).Whole.Area / area, 1.0, 1e-4);
}

TEST(MolecularFlowSurface, BadAtomsAreToldInASentence)
{
  const auto filter = FilterOf(vtkNew<vtkPolyData>());
  Errors errors(filter);
  const std::vector<Ball> sound{ { { 0.0, 0.0, 0.0 }, 1.5 }, { { 2.0, 0.0, 0.0 }, 1.5 } };
  EXPECT_EQ(errors.Of(vtkNew<vtkPolyData>()), "");
  EXPECT_TRUE(errors.IsEmpty());
  EXPECT_EQ(errors.Of(AtomsOf(sound)), "");
  EXPECT_FALSE(errors.IsEmpty());
  const auto refused = [&](std::vector<Ball> balls, const char* sentence)
  {
    const std::string said = errors.Of(AtomsOf(balls));
    EXPECT_NE(said.find(sentence), std::string::npos) << said;
    EXPECT_TRUE(errors.IsEmpty()) << sentence;
    EXPECT_EQ(errors.Of(AtomsOf(sound)), "");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused({ { { 0.0, nan, 0.0 }, 1.5 } }, "Atom 0 has a coordinate");
  refused({ sound[0], { { 0.0, 0.0, 0.0 }, -1.0 } }, "Atom 1 has a coordinate or radius");
  refused({ { { 0.0, 0.0, 0.0 }, 1.0 / 0.0 } }, "Atom 0 has a coordinate or radius");
  refused({ { { 0.0, 0.0, 0.0 }, 0.0 } }, "None of the 1 atoms has a radius above 0");
  refused({ { { 0.0, 0.0, 0.0 }, nan } }, "None of the 1 atoms has a radius above 0");
  refused({ { { 0.3, 0.3, 0.3 }, 1e-3 } }, "the surface vanishes");
  refused({ sound[0], { { 1e300, 0.0, 0.0 }, 1.5 } }, "more than 2^31 nodes");
  std::vector<Ball> far = RandomBalls(50, 10.0);
  far.push_back({ { 1e6, 1e6, 0.0 }, 1.5 });
  refused(far, "of memory, of which");
  refused(far, "Atom 50 lies");
  EXPECT_NE(errors.Of(AtomsOf({ sound[0], { { 2.0, 0.0, 0.0 }, nan } })).find("1 of 2 atoms"),
    std::string::npos);
  EXPECT_FALSE(errors.IsEmpty());
  // Atoms of radius 0 and atoms in the same place leave no trace.
  errors.Of(AtomsOf(sound));
  const double area = MeasuresOf(filter->GetOutput()).Whole.Area;
  EXPECT_EQ(errors.Of(AtomsOf({ sound[0], sound[1], sound[1], { { 1.0, 0.0, 0.0 }, 0.0 } })), "");
  EXPECT_EQ(MeasuresOf(filter->GetOutput()).Whole.Area, area);
  const auto bare = AtomsOf(sound);
  bare->GetPointData()->RemoveArray("Radius");
  EXPECT_NE(errors.Of(bare).find("no point array Radius of radii"), std::string::npos);
  EXPECT_TRUE(errors.IsEmpty());
}

TEST(MolecularFlowSurface, NumbersOutOfRangeAreToldInASentence)
{
  const auto atoms = AtomsOf({ { { 0.0, 0.0, 0.0 }, 1.5 } });
  const auto filter = FilterOf(atoms);
  Errors errors(filter);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using Set = void (vtkMolecularFlowSurface::*)(double);
  struct Property
  {
    const char* Name;
    Set Setter;
    double Sound;
    std::vector<double> Bad;
  };
  using Filter = vtkMolecularFlowSurface;
  const std::vector<Property> properties{
    { "Spacing", &Filter::SetSpacing, 0.5, { 0.0, -1.0, nan, 1.0 / 0.0 } },
    { "Padding", &Filter::SetPadding, 1.7, { -1.0, nan, 1.0 / 0.0 } },
    { "Enlargement", &Filter::SetEnlargement, 1.3, { 0.9, nan, 1.0 / 0.0 } },
    { "EvolutionTime", &Filter::SetEvolutionTime, 2.5, { -1.0, nan, 1.0 / 0.0 } },
    { "ProbeRadius", &Filter::SetProbeRadius, 0.0, { -1.0, nan, 1.0 / 0.0 } },
    { "IsoValue", &Filter::SetIsoValue, 0.5, { 0.0, 1.0, -1.0, nan } },
    { "SurfaceTension", &Filter::SetSurfaceTension, 0.0700, { 0.0, -1.0, nan, 1.0 / 0.0 } },
    { "Pressure", &Filter::SetPressure, 0.0464, { nan, 1.0 / 0.0 } },
  };
  for (const Property& property : properties)
  {
    for (const double bad : property.Bad)
    {
      (filter->*property.Setter)(bad);
      const std::string said = errors.Of(atoms);
      EXPECT_NE(said.find(std::string(property.Name) + " is "), std::string::npos)
        << property.Name << " " << bad << ": " << said;
      EXPECT_TRUE(errors.IsEmpty()) << property.Name << " " << bad;
    }
    (filter->*property.Setter)(property.Sound);
    EXPECT_EQ(errors.Of(atoms), "") << property.Name;
  }
  const auto small = AtomsOf({ { { 0.0, 0.0, 0.0 }, 0.4 } });
  filter->SetIsoValue(0.99);
  EXPECT_NE(errors.Of(small).find("vanishes at an IsoValue"), std::string::npos);
  EXPECT_TRUE(errors.IsEmpty());
  filter->SetIsoValue(0.5);
  filter->SetSpacing(1e-3);
  EXPECT_NE(errors.Of(atoms).find("of memory, of which"), std::string::npos);
  filter->SetSpacing(1e-12);
  EXPECT_NE(errors.Of(atoms).find("more than 2^31 nodes"), std::string::npos);
  filter->SetSpacing(0.5);
  filter->SetEvolutionTime(1e9);
  EXPECT_NE(errors.Of(atoms).find("more than ten million steps"), std::string::npos);
}

TEST(MolecularFlowSurface, ProgressRisesAndStopIsHonoured)
{
  struct State
  {
    std::vector<double> Told;
    double StopAt = 2.0;
  } state;
  const auto filter = FilterOf(AtomsOf(RandomBalls(1000, 22.0)));
  filter->SetSteady(true);
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&state);
  watch->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      auto* seen = static_cast<State*>(data);
      seen->Told.push_back(algorithm->GetProgress());
      algorithm->SetAbortExecute(algorithm->GetProgress() >= seen->StopAt ? 1 : 0);
    });
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  EXPECT_TRUE(std::is_sorted(state.Told.begin(), state.Told.end()));
  EXPECT_GT(state.Told.size(), 50u);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  for (const double at : { 0.0, 0.3, 0.8 })
  {
    state.StopAt = at;
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << at;
    EXPECT_EQ(filter->GetImage()->GetNumberOfPoints(), 0) << at;
  }
}

TEST(MolecularFlowSurface, LysozymeByTime)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew/1hew.pqr");
  const auto filter =
    FilterOf(AtomsOf(BallsOfPQR((SharedDataFolder() / "molecules/1hew/1hew.pqr").string())));
  struct Case
  {
    double Enlargement, Time, Area, Volume;
    std::size_t Components; // 0: not compared, before T = 2.5
    vtkIdType Genus;
  };
  // ../shared/flows.md, section 2.
  for (const Case& c :
    { Case{ 1.0, 0.5, 6259.0, 17092.0, 0, 0 }, Case{ 1.0, 2.5, 4956.0, 18891.0, 1, 0 },
      Case{ 1.3, 0.0, 7216.0, 19904.0, 0, 0 }, Case{ 1.3, 0.5, 5228.0, 19562.0, 0, 0 },
      Case{ 1.3, 2.5, 4768.0, 19862.0, 1, 0 }, Case{ 1.3, 10.0, 4569.0, 21284.0, 1, 0 },
      Case{ 2.0, 0.0, 6630.0, 28247.0, 0, 0 }, Case{ 2.0, 2.5, 5018.0, 26635.0, 1, 0 } })
  {
    filter->SetEnlargement(c.Enlargement);
    filter->SetEvolutionTime(c.Time);
    filter->Update();
    const SurfaceMeasures found = MeasuresOf(filter->GetOutput());
    std::cout << c.Enlargement << " " << c.Time << ": " << found.Whole.Area << " "
              << found.Whole.Volume << " " << found.Components.size() << " " << found.Whole.Genus
              << "\n";
    // The table's areas of the rough surfaces before that were measured in another way than by
    // these triangles, which cut the creases between atoms.
    const double within = c.Time < 2.0 ? 0.015 : 0.01;
    EXPECT_NEAR(found.Whole.Area / c.Area, 1.0, within) << c.Enlargement << " " << c.Time;
    EXPECT_NEAR(found.Whole.Volume / c.Volume, 1.0, 0.01) << c.Enlargement << " " << c.Time;
    EXPECT_TRUE(found.Whole.IsClosed());
    if (c.Components > 0)
    {
      EXPECT_EQ(found.Components.size(), c.Components);
      EXPECT_EQ(found.Whole.Genus, c.Genus);
    }
  }
}

TEST(MolecularFlowSurface, SteadyLysozymeDoesNotKnowWhereItBegan)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew/1hew.pqr");
  const auto filter =
    FilterOf(AtomsOf(BallsOfPQR((SharedDataFolder() / "molecules/1hew/1hew.pqr").string())));
  filter->SetSteady(true);
  std::vector<double> areas;
  std::vector<double> volumes;
  for (const double enlargement : { 1.0, 1.3, 2.0 })
  {
    filter->SetEnlargement(enlargement);
    filter->Update();
    const SurfaceMeasures found = MeasuresOf(filter->GetOutput());
    EXPECT_EQ(found.Components.size(), 1u);
    EXPECT_EQ(found.Whole.Genus, 0);
    areas.push_back(found.Whole.Area);
    volumes.push_back(found.Whole.Volume);
  }
  const auto [leastArea, mostArea] = std::minmax_element(areas.begin(), areas.end());
  const auto [leastVolume, mostVolume] = std::minmax_element(volumes.begin(), volumes.end());
  EXPECT_NEAR(areas[1] / 4490.4, 1.0, 0.01);
  EXPECT_LT(*mostArea / *leastArea - 1.0, 0.003);
  EXPECT_LT(*mostVolume / *leastVolume - 1.0, 0.015);
}
