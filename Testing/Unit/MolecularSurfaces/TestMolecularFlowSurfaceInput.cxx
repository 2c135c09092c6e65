// How vtkMolecularFlowSurface interprets its input: radii, names, time steps, bad atoms and
// numbers.

#include "Atoms/MoleculeAtoms.h"
#include "FlowCases.h"

#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMath.h>
#include <vtkMolecule.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedShortArray.h>

#include <gtest/gtest.h>

#include <limits>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

struct Errors
{
  explicit Errors(vtkMolecularFlowSurface* filter)
    : Filter(filter)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    filter->AddObserver(vtkCommand::WarningEvent, this->Observer);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Pipeline);
  }
  std::string Of(vtkDataObject* atoms)
  {
    this->Observer->Clear();
    this->Filter->SetInputDataObject(atoms);
    this->Filter->Modified();
    this->Filter->Update();
    return this->Observer->GetErrorMessage() + this->Observer->GetWarningMessage();
  }
  bool IsEmpty() const
  {
    return this->Filter->GetOutput()->GetNumberOfPoints() == 0 &&
      this->Filter->GetImage()->GetNumberOfPoints() == 0 &&
      this->Filter->GetHistory()->GetNumberOfRows() == 0;
  }

  vtkMolecularFlowSurface* Filter;
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkTest::ErrorObserver> Pipeline;
};

/// A glycine and a water, as a file has them; with a hydrogen on request.
vtkSmartPointer<vtkPolyData> GlycineInWater(bool hydrogen)
{
  struct Atom
  {
    const char* Name;
    const char* Residue;
    int Element;
    Ball Place;
  };
  std::vector<Atom> atoms{ { "N", "GLY", 7, { { 0.0, 0.0, 0.0 }, 1.55 } },
    { "CA", "GLY", 6, { { 1.46, 0.0, 0.0 }, 1.70 } },
    { "C", "GLY", 6, { { 2.0, 1.4, 0.0 }, 1.70 } }, { "O", "GLY", 8, { { 1.3, 2.4, 0.0 }, 1.52 } },
    { "O", "HOH", 8, { { 9.0, 0.0, 0.0 }, 1.52 } } };
  if (hydrogen)
  {
    atoms.push_back({ "HA", "GLY", 1, { { 1.8, -0.5, 0.9 }, 1.20 } });
  }
  std::vector<Ball> balls;
  vtkNew<vtkStringArray> names;
  names->SetName("AtomName");
  vtkNew<vtkStringArray> residues;
  residues->SetName("ResidueName");
  vtkNew<vtkUnsignedShortArray> elements;
  elements->SetName("Element");
  for (const Atom& atom : atoms)
  {
    balls.push_back(atom.Place);
    names->InsertNextValue(atom.Name);
    residues->InsertNextValue(atom.Residue);
    elements->InsertNextValue(static_cast<unsigned short>(atom.Element));
  }
  const auto points = MakeAtoms(balls);
  points->GetPointData()->AddArray(names);
  points->GetPointData()->AddArray(residues);
  points->GetPointData()->AddArray(elements);
  return points;
}

}

TEST(MolecularFlowSurface, MissingRadiiAreAssignedByElement)
{
  vtkNew<vtkMolecule> molecule;
  molecule->AppendAtom(6, 0.0, 0.0, 0.0);
  molecule->AppendAtom(8, 1.2, 0.0, 0.0);
  const auto filter = MakeFilter(molecule);
  filter->SetSteady(true);
  filter->Update();
  const double byMolecule = MeasureFlowSurface(filter->GetOutput()).Whole.Area;
  EXPECT_GT(byMolecule, 4.0 * vtkMath::Pi() * 1.7 * 1.7);
  const auto points = MakeAtoms({ { { 0.0, 0.0, 0.0 }, 1.70 }, { { 1.2, 0.0, 0.0 }, 1.52 } });
  filter->SetInputDataObject(points);
  filter->Update();
  EXPECT_NEAR(MeasureFlowSurface(filter->GetOutput()).Whole.Area, byMolecule, 1e-4);
  points->GetPointData()->RemoveArray("Radius");
  vtkNew<vtkUnsignedShortArray> elements;
  elements->SetName("Element");
  elements->InsertNextValue(6);
  elements->InsertNextValue(8);
  points->GetPointData()->AddArray(elements);
  filter->Modified();
  filter->Update();
  EXPECT_NEAR(MeasureFlowSurface(filter->GetOutput()).Whole.Area, byMolecule, 1e-4);
}

/// Values for elements beyond the atoms were written beyond the radii.
TEST(MolecularFlowSurface, ElementsBeyondTheAtomsAreNotRead)
{
  const auto pointsWith = [](vtkIdType elements)
  {
    auto atoms = GlycineInWater(false);
    atoms->GetPointData()->RemoveArray("Radius");
    vtkNew<vtkUnsignedShortArray> element;
    element->SetName("Element");
    element->SetNumberOfTuples(elements);
    element->FillValue(6);
    atoms->GetPointData()->AddArray(element);
    vtkNew<vtkMolecularFlowSurface> filter;
    Errors errors(filter);
    const std::string said = errors.Of(atoms);
    EXPECT_EQ(said.find("damaged") != std::string::npos, elements < atoms->GetNumberOfPoints());
    return filter->GetOutput()->GetNumberOfPoints();
  };
  const vtkIdType count = GlycineInWater(false)->GetNumberOfPoints();
  EXPECT_GT(pointsWith(count), 100);
  EXPECT_EQ(pointsWith(1000), pointsWith(count));
  EXPECT_EQ(pointsWith(count - 1), 0);
}

TEST(MolecularFlowSurface, InputIsUnchangedAndFloatsWork)
{
  const auto doubles = MakeAtoms(Catenoid().Balls());
  const auto floats = MakeAtoms(Catenoid().Balls(), VTK_FLOAT);
  const auto before = doubles->GetMTime();
  const auto filter = MakeFilter(doubles);
  filter->Update();
  EXPECT_EQ(doubles->GetMTime(), before);
  const double area = MeasureFlowSurface(filter->GetOutput()).Whole.Area;
  filter->SetInputDataObject(floats);
  filter->Update();
  EXPECT_NEAR(MeasureFlowSurface(filter->GetOutput()).Whole.Area / area, 1.0, 1e-4);
}

TEST(MolecularFlowSurface, WaterIsDroppedWithAMessageUnlessIncluded)
{
  const auto filter = MakeFilter(GlycineInWater(true));
  filter->Update();
  EXPECT_EQ(MeasureFlowSurface(filter->GetOutput()).Components.size(), 1u);
  for (vtkDataObject* output : { static_cast<vtkDataObject*>(filter->GetOutput()),
         static_cast<vtkDataObject*>(filter->GetImage()) })
  {
    auto* notes = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray("Notes"));
    ASSERT_NE(notes, nullptr);
    ASSERT_EQ(notes->GetNumberOfValues(), 1);
    EXPECT_EQ(notes->GetValue(0), "Water was left out: 1 HOH (1 heavy atom).");
  }
  filter->IncludeWatersOn();
  filter->Update();
  EXPECT_EQ(MeasureFlowSurface(filter->GetOutput()).Components.size(), 2u);
  Errors errors(filter);
  filter->IncludeWatersOff();
  const auto wet = MakeAtoms({ { { 0.0, 0.0, 0.0 }, 1.5 } });
  vtkNew<vtkStringArray> residues;
  residues->SetName("ResidueName");
  residues->InsertNextValue("HOH");
  wet->GetPointData()->AddArray(residues);
  EXPECT_NE(errors.Of(wet).find("All atoms are water"), std::string::npos);
  EXPECT_TRUE(errors.IsEmpty());
}

TEST(MolecularFlowSurface, ChainsWithoutHydrogensHaveRadiiOfUnitedAtoms)
{
  const auto radii = [](vtkDataObject* atoms, bool unitedAtoms = true)
  {
    std::vector<double> found;
    for (const Ball& ball :
      ReadAtoms(atoms, SelectWholeMolecule("Radius", false, unitedAtoms)).Balls)
    {
      found.push_back(ball.Radius);
    }
    return found;
  };
  const std::vector<double> plain{ 1.55, 1.70, 1.70, 1.52 };
  const std::vector<double> united{ 1.75, 1.85, 1.85, 1.65 };
  const auto bare = GlycineInWater(false);
  EXPECT_EQ(radii(bare), united);
  EXPECT_EQ(radii(bare, false), plain);
  EXPECT_EQ(ReadAtoms(bare, SelectWholeMolecule("Radius")).Notes.size(), 2u);
  EXPECT_EQ(ReadAtoms(bare, SelectWholeMolecule("None")).Balls[1].Radius, 1.85); // by element
  // Hydrogens, radii of a force field, and atoms outside of chains are unchanged.
  EXPECT_EQ(radii(GlycineInWater(true))[1], 1.70);
  const auto charged = GlycineInWater(false);
  charged->GetPointData()->GetArray("Radius")->SetComponent(1, 0, 1.908);
  EXPECT_EQ(radii(charged)[0], 1.55);
  const auto ligand = GlycineInWater(false);
  auto* residues =
    vtkStringArray::SafeDownCast(ligand->GetPointData()->GetAbstractArray("ResidueName"));
  for (vtkIdType i = 0; i < 4; ++i)
  {
    residues->SetValue(i, "LIG");
  }
  EXPECT_EQ(radii(ligand), plain);
}

TEST(MolecularFlowSurface, PipelineTimeIsFlowTime)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const auto filter = MakeFilter(MakeAtoms(RandomBalls(60, 12.0)));
  filter->SetEvolutionTime(1.0);
  filter->Update();
  const double early = MeasureFlowSurface(filter->GetOutput()).Whole.Area;
  filter->SetEvolutionTime(2.0);
  filter->Update();
  const double whole = MeasureFlowSurface(filter->GetOutput()).Whole.Area;
  filter->SetTimeSteps(4);
  filter->UpdateInformation();
  vtkInformation* told = filter->GetOutputInformation(0);
  ASSERT_EQ(told->Length(Pipeline::TIME_STEPS()), 5);
  EXPECT_EQ(told->Get(Pipeline::TIME_STEPS(), 4), 2.0);
  EXPECT_EQ(filter->GetOutputInformation(1)->Length(Pipeline::TIME_STEPS()), 5);
  filter->UpdateTimeStep(0.9); // the nearest is taken
  EXPECT_NEAR(MeasureFlowSurface(filter->GetOutput()).Whole.Area, early, 1e-9);
  EXPECT_EQ(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), 1.0);
  filter->UpdateTimeStep(7.0);
  EXPECT_NEAR(MeasureFlowSurface(filter->GetOutput()).Whole.Area, whole, 1e-9);
  filter->SteadyOn();
  filter->UpdateInformation();
  EXPECT_FALSE(told->Has(Pipeline::TIME_STEPS()));
}

TEST(MolecularFlowSurface, ReportsBadAtoms)
{
  const auto filter = MakeFilter(vtkNew<vtkPolyData>());
  Errors errors(filter);
  const std::vector<Ball> sound{ { { 0.0, 0.0, 0.0 }, 1.5 }, { { 2.0, 0.0, 0.0 }, 1.5 } };
  EXPECT_EQ(errors.Of(vtkNew<vtkPolyData>()), "");
  EXPECT_TRUE(errors.IsEmpty());
  EXPECT_EQ(errors.Of(MakeAtoms(sound)), "");
  EXPECT_FALSE(errors.IsEmpty());
  const auto refused = [&](std::vector<Ball> balls, const char* sentence)
  {
    const std::string said = errors.Of(MakeAtoms(balls));
    EXPECT_NE(said.find(sentence), std::string::npos) << said;
    EXPECT_TRUE(errors.IsEmpty()) << sentence;
    EXPECT_EQ(errors.Of(MakeAtoms(sound)), "");
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused({ { { 0.0, nan, 0.0 }, 1.5 } }, "Atom 0 has a coordinate");
  refused({ sound[0], { { 0.0, 0.0, 0.0 }, -1.0 } }, "The radius of atom 1 is -1");
  refused({ { { 0.0, 0.0, 0.0 }, 1.0 / 0.0 } }, "The radius of atom 0 is inf");
  refused({ { { 0.0, 0.0, 0.0 }, 0.0 } }, "None of the 1 atoms has a radius above 0");
  refused({ { { 0.0, 0.0, 0.0 }, nan } }, "None of the 1 atoms has a radius above 0");
  refused({ { { 0.3, 0.3, 0.3 }, 1e-3 } }, "the surface vanishes");
  refused({ sound[0], { { 1e90, 0.0, 0.0 }, 1.5 } }, "more than 2^31 nodes");
  refused(
    { sound[0], { { 1e300, 0.0, 0.0 }, 1.5 } }, "Point 1 of input 0 has the coordinate 1e+300");
  std::vector<Ball> far = RandomBalls(50, 10.0);
  far.push_back({ { 1e6, 1e6, 0.0 }, 1.5 });
  refused(far, "of memory, but only");
  refused(far, "Atom 50 lies");
  EXPECT_NE(errors.Of(MakeAtoms({ sound[0], { { 2.0, 0.0, 0.0 }, nan } })).find("1 of 2 atoms"),
    std::string::npos);
  EXPECT_FALSE(errors.IsEmpty());
  // Atoms of radius 0 have no effect, and coincident atoms none but a warning.
  errors.Of(MakeAtoms(sound));
  const double area = MeasureFlowSurface(filter->GetOutput()).Whole.Area;
  EXPECT_NE(errors.Of(MakeAtoms({ sound[0], sound[1], sound[1], { { 1.0, 0.0, 0.0 }, 0.0 } }))
              .find("1 of 4 atoms lie exactly where another one lies"),
    std::string::npos);
  EXPECT_EQ(MeasureFlowSurface(filter->GetOutput()).Whole.Area, area);
  const auto bare = MakeAtoms(sound);
  bare->GetPointData()->RemoveArray("Radius");
  EXPECT_NE(errors.Of(bare).find("no point array Radius of radii"), std::string::npos);
  EXPECT_TRUE(errors.IsEmpty());
}

TEST(MolecularFlowSurface, ReportsNumbersOutOfRange)
{
  const auto atoms = MakeAtoms({ { { 0.0, 0.0, 0.0 }, 1.5 } });
  const auto filter = MakeFilter(atoms);
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
    { "Level", &Filter::SetLevel, 0.5, { 0.0, 1.0, -1.0, nan } },
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
  const auto small = MakeAtoms({ { { 0.0, 0.0, 0.0 }, 0.4 } });
  filter->SetLevel(0.99);
  EXPECT_NE(errors.Of(small).find("vanishes at a Level"), std::string::npos);
  EXPECT_TRUE(errors.IsEmpty());
  filter->SetLevel(0.5);
  filter->SetSpacing(1e-3);
  EXPECT_NE(errors.Of(atoms).find("of memory, but only"), std::string::npos);
  filter->SetSpacing(1e-12);
  EXPECT_NE(errors.Of(atoms).find("more than 2^31 nodes"), std::string::npos);
  filter->SetSpacing(0.5);
  filter->SetEvolutionTime(1e9);
  EXPECT_NE(errors.Of(atoms).find("more than ten million steps"), std::string::npos);
}
