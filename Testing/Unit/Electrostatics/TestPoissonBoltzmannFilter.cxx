// vtkPoissonBoltzmann on spheres given in all the ways a surface can be given: levels of distances
// and densities in float and double, cut off, on anisotropic and turned grids off the origin, as
// polygons, and made of the atoms; and what it refuses.

#include "vtkMolecularDensity.h"
#include "vtkPoissonBoltzmann.h"

#include "Core/PolyDataTriangles.h"
#include "KirkwoodSphere.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSphereSource.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

using namespace isthmus;
using isthmus::testing::KirkwoodSphere;

namespace
{

KirkwoodSphere Sphere()
{
  KirkwoodSphere s;
  s.Center = { 100.11, -50.07, 7.05 };
  s.Radius = 5.0;
  const auto add = [&](double q, double x, double y, double z) {
    s.Charges.push_back({ { s.Center[0] + x, s.Center[1] + y, s.Center[2] + z }, q, 1.5 });
  };
  add(1, 2.5, 0, 0);
  add(-1, 0, -3, 0.5);
  add(1, -1, 1.5, 3);
  return s;
}

vtkSmartPointer<vtkPolyData> Atoms(const KirkwoodSphere& sphere)
{
  auto atoms = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> charges, radii;
  charges->SetName("Charge");
  radii->SetName("Radius");
  for (const ChargedAtom& atom : sphere.Charges)
  {
    points->InsertNextPoint(atom.Position.data());
    charges->InsertNextValue(atom.Charge);
    radii->InsertNextValue(atom.Radius);
  }
  atoms->SetPoints(points);
  atoms->GetPointData()->AddArray(charges);
  atoms->GetPointData()->AddArray(radii);
  return atoms;
}

struct GridChoice
{
  Point3 Spacing{ 0.5, 0.5, 0.5 };
  double Half = 9.0;
  bool Turned = false;
  bool Float = false;
};

/// f(distance from the center) on a grid around the sphere.
vtkSmartPointer<vtkImageData> Volume(
  const KirkwoodSphere& sphere, const GridChoice& choice, const std::function<double(double)>& f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  int extent[6];
  for (int a = 0; a < 3; ++a)
  {
    const double h = choice.Spacing[static_cast<std::size_t>(a)];
    extent[2 * a] = 3 - 4 * a; // extents need not begin at 0
    extent[2 * a + 1] = extent[2 * a] + static_cast<int>(2.0 * choice.Half / h);
  }
  image->SetExtent(extent);
  image->SetSpacing(choice.Spacing.data());
  if (choice.Turned)
  {
    const double c = 0.6, s = 0.8;
    image->SetDirectionMatrix(c, -s, 0, s, c, 0, 0, 0, 1);
  }
  // The first node half a box from the center along each axis of the grid.
  double first[3], ijk[3] = { double(extent[0]), double(extent[2]), double(extent[4]) };
  for (int a = 0; a < 3; ++a)
  {
    ijk[a] += std::floor(choice.Half / image->GetSpacing()[a]) + 0.13;
  }
  image->TransformContinuousIndexToPhysicalPoint(ijk, first);
  image->SetOrigin(
    sphere.Center[0] - first[0], sphere.Center[1] - first[1], sphere.Center[2] - first[2]);
  vtkSmartPointer<vtkDataArray> values = choice.Float
    ? vtkSmartPointer<vtkDataArray>(vtkSmartPointer<vtkFloatArray>::New())
    : vtkSmartPointer<vtkDataArray>(vtkSmartPointer<vtkDoubleArray>::New());
  values->SetName("f");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 x;
    image->GetPoint(i, x.data());
    values->SetTuple1(i, f(sphere.Distance(x)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

double Field(vtkImageData* image, const char* name)
{
  return vtkArrayDownCast<vtkDoubleArray>(image->GetFieldData()->GetArray(name))->GetValue(0);
}

struct Errors
{
  double Energy = 0.0, Outside = 0.0, Reaction = 0.0, Surface = 0.0;
};

Errors RecordErrors(vtkPoissonBoltzmann* filter, const KirkwoodSphere& sphere)
{
  Errors errors;
  vtkImageData* image = filter->GetOutput();
  const double exact = sphere.Energy() * units::ThermalKilocalorie(298.15);
  errors.Energy = std::abs(Field(image, "SolvationEnergy") / exact - 1.0);
  auto* potential = image->GetPointData()->GetArray("Potential");
  auto* reaction = image->GetPointData()->GetArray("ReactionPotential");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 x;
    image->GetPoint(i, x.data());
    const bool inside = sphere.Distance(x) < sphere.Radius;
    const double outside = inside ? 0.0 : sphere.Outside(x);
    const double rest = inside ? sphere.Reaction(x) : outside - sphere.Coulomb(x);
    errors.Reaction = std::max(errors.Reaction, std::abs(reaction->GetTuple1(i) - rest));
    if (!inside)
    {
      errors.Outside = std::max(errors.Outside, std::abs(potential->GetTuple1(i) - outside));
    }
  }
  vtkPolyData* surface = filter->GetSurface();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Point3 x;
    surface->GetPoint(i, x.data());
    errors.Surface = std::max(errors.Surface,
      std::abs(surface->GetPointData()->GetArray("Potential")->GetTuple1(i) - sphere.Outside(x)));
  }
  return errors;
}

Errors RunOn(vtkDataObject* surface, double isoValue, bool insideIsHigher)
{
  const KirkwoodSphere sphere = Sphere();
  vtkNew<vtkPoissonBoltzmann> filter;
  filter->SetInputDataObject(0, Atoms(sphere));
  filter->SetInputDataObject(1, surface);
  filter->SetLevel(isoValue);
  filter->SetInsideIsHigher(insideIsHigher);
  filter->SetIonicStrength(0.0);
  filter->Update();
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
  if (auto* image = vtkImageData::SafeDownCast(surface))
  {
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), image->GetNumberOfPoints());
    EXPECT_EQ(filter->GetOutput()->GetExtent()[0], image->GetExtent()[0]);
    EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("f"), nullptr);
  }
  EXPECT_GT(filter->GetSurface()->GetNumberOfPolys(), 1000);
  return RecordErrors(filter, sphere);
}

void ExpectSmall(const Errors& errors)
{
  std::printf("energy %.2e outside %.4f reaction %.4f surface %.4f\n", errors.Energy,
    errors.Outside, errors.Reaction, errors.Surface);
  EXPECT_LT(errors.Energy, 1e-3);
  EXPECT_LT(errors.Outside, 0.1);
  EXPECT_LT(errors.Reaction, 0.25);
  EXPECT_LT(errors.Surface, 0.2);
}

double Minus(double r)
{
  return 5.0 - r;
}
double Plus(double r)
{
  return r - 5.0;
}
double Gaussian(double r)
{
  return std::exp(-2.3 * (r * r / 25.0 - 1.0));
}

TEST(PoissonBoltzmannFilter, NegatedDistance)
{
  ExpectSmall(RunOn(Volume(Sphere(), {}, Minus), 0.0, true));
}

TEST(PoissonBoltzmannFilter, DistanceInFloat)
{
  GridChoice choice;
  choice.Float = true;
  ExpectSmall(RunOn(Volume(Sphere(), choice, Plus), 0.0, false));
}

TEST(PoissonBoltzmannFilter, GaussiansInFloat)
{
  GridChoice choice;
  choice.Float = true;
  ExpectSmall(RunOn(Volume(Sphere(), choice, Gaussian), 1.0, true));
}

TEST(PoissonBoltzmannFilter, AnisotropicSpacing)
{
  GridChoice choice;
  choice.Spacing = { 0.4, 0.5, 0.65 };
  ExpectSmall(RunOn(Volume(Sphere(), choice, Minus), 0.0, true));
}

TEST(PoissonBoltzmannFilter, TurnedGrid)
{
  GridChoice choice;
  choice.Turned = true;
  ExpectSmall(RunOn(Volume(Sphere(), choice, Gaussian), 1.0, true));
}

TEST(PoissonBoltzmannFilter, GridThatEndsNearTheSurface)
{
  GridChoice choice;
  choice.Half = 6.7;
  ExpectSmall(RunOn(Volume(Sphere(), choice, Minus), 0.0, true));
}

TEST(PoissonBoltzmannFilter, CutOffValuesAreReplacedByDistance)
{
  const auto cut = [](double r) { return std::min(std::max(Minus(r), -0.6), 0.6); };
  const Errors errors = RunOn(Volume(Sphere(), {}, cut), 0.0, true);
  EXPECT_LT(errors.Energy, 5e-3);
  EXPECT_LT(errors.Outside, 0.2);
}

TEST(PoissonBoltzmannFilter, Polygons)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(5.0);
  ball->SetCenter(100.11, -50.07, 7.05);
  ball->SetThetaResolution(96);
  ball->SetPhiResolution(96);
  ball->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  ball->Update();
  const Errors errors = RunOn(ball->GetOutput(), 0.0, true);
  EXPECT_LT(errors.Energy, 3e-3);
  EXPECT_LT(errors.Outside, 0.3);
}

TEST(PoissonBoltzmannFilter, BornIonWithoutASurface)
{
  // A single atom: the level of its Gaussian is its sphere, and defaults are 2 and 80.
  KirkwoodSphere ion;
  ion.Radius = 2.5;
  ion.Charges.push_back({ { 0.2, 0.1, -0.3 }, 1.0, 2.5 });
  ion.Center = ion.Charges.front().Position;
  vtkNew<vtkPoissonBoltzmann> filter;
  filter->SetInputDataObject(0, Atoms(ion));
  filter->SetSpacing(0.25);
  filter->SetPadding(5.0);
  filter->Update();
  // Born: -1/2 C q^2 (1/2 - 1/80) / R, with C = 332.0637 kcal angstrom / mol.
  EXPECT_NEAR(Field(filter->GetOutput(), "SolvationEnergy"),
    -0.5 * 332.0637 * (0.5 - 1.0 / 80.0) / 2.5, 5e-3);
  EXPECT_NEAR(Field(filter->GetOutput(), "SolvationEnergyKilojoule"),
    4.184 * Field(filter->GetOutput(), "SolvationEnergy"), 1e-9);
  EXPECT_EQ(filter->GetAtoms()->GetPointData()->GetArray("AtomEnergy")->GetTuple1(0),
    Field(filter->GetOutput(), "SolvationEnergy"));
  EXPECT_GT(Field(filter->GetOutput(), "Iterations"), 0.0);
}

/// Born's energy of an ion, and that of the filter.
struct IonEnergies
{
  double Born, Filter;
};

IonEnergies SolveIon(double radius, double spacing, double padding, const Point3& place)
{
  KirkwoodSphere ion;
  ion.Charges.push_back({ place, 1.0, radius });
  vtkNew<vtkPoissonBoltzmann> filter;
  filter->SetInputDataObject(0, Atoms(ion));
  filter->SetSpacing(spacing);
  filter->SetPadding(padding);
  filter->Update();
  return { -0.5 * 332.0637 * (0.5 - 1.0 / 80.0) / radius,
    Field(filter->GetOutput(), "SolvationEnergy") };
}

TEST(PoissonBoltzmannFilter, SmallIonsHaveBornsEnergy)
{
  for (const Point3& place :
    { Point3{ 0.1, 0.2, 0.3 }, Point3{ 0.0, 0.0, 0.0 }, Point3{ -3.37, 12.21, 0.255 } })
  {
    for (double ratio = 1.1; ratio < 3.0; ratio += 0.1)
    {
      const IonEnergies e = SolveIon(ratio * 0.5, 0.5, 10.0, place);
      EXPECT_NEAR(e.Filter / e.Born, 1.0, ratio < 1.45 ? 0.02 : 2e-3) << ratio;
    }
    const IonEnergies coarse = SolveIon(1.3, 1.0, 10.0, place);
    EXPECT_NEAR(coarse.Filter / coarse.Born, 1.0, 0.01);
  }
}

TEST(PoissonBoltzmannFilter, SmallIonsInADensityHaveBornsEnergy)
{
  // Molecular Density neglects terms below 1e-6, near the surface of a small ion.
  for (double radius = 0.7; radius < 1.5; radius += 0.1)
  {
    KirkwoodSphere ion;
    ion.Charges.push_back({ { 0.1, 0.2, 0.3 }, 1.0, radius });
    vtkNew<vtkMolecularDensity> density;
    density->SetInputDataObject(Atoms(ion));
    density->SetSpacing(0.5);
    density->SetPadding(8.0, 8.0, 8.0);
    vtkNew<vtkPoissonBoltzmann> filter;
    filter->SetInputDataObject(0, Atoms(ion));
    filter->SetSurfaceConnection(density->GetOutputPort());
    filter->SetLevel(1.0);
    filter->Update();
    const double born = -0.5 * 332.0637 * (0.5 - 1.0 / 80.0) / radius;
    const double energy = Field(filter->GetOutput(), "SolvationEnergy");
    EXPECT_NEAR(energy / born, 1.0, 2e-3) << radius;
  }
}

TEST(PoissonBoltzmannFilter, SmallBoxesHaveBornsEnergy)
{
  for (const double radius : { 1.5, 2.0, 3.0 })
  {
    for (const double padding : { 0.0, 1.0, 2.0, 3.0, 4.0, 5.0 })
    {
      const IonEnergies e = SolveIon(radius, 0.5, padding, { 0.1, 0.2, 0.3 });
      EXPECT_NEAR(e.Filter / e.Born, 1.0, padding < 1.0 ? 5e-3 : 1e-3) << radius << " " << padding;
    }
  }
}

// The surface over which the border's potential is integrated needs room for its stencils, whatever
// the number of nodes between molecule and border is, and whatever their spacing.
TEST(PoissonBoltzmannFilter, AnyNumberOfNodesToTheBorderGivesBornsEnergy)
{
  for (const auto& [radius, spacing] : { std::pair(4.0, 0.5), std::pair(16.0, 2.0) })
  {
    for (double nodes = 0.5; nodes < 8.0; nodes += 0.5)
    {
      const IonEnergies e = SolveIon(radius, spacing, nodes * spacing, { 0.1, 0.2, 0.3 });
      EXPECT_NEAR(e.Filter / e.Born, 1.0, nodes < 2.0 ? 5e-3 : 1e-3) << radius << " " << nodes;
    }
  }
}

TEST(PoissonBoltzmannFilter, TheErrorCoversAPotentialOfZeroAtTheBorder)
{
  for (const double padding : { 2.0, 4.0, 10.0 })
  {
    for (const double charge : { -3.0, 1.0 })
    {
      KirkwoodSphere ion;
      ion.Charges.push_back({ { 0.1, 0.2, 0.3 }, charge, 5.0 });
      vtkNew<vtkPoissonBoltzmann> filter;
      filter->SetInputDataObject(0, Atoms(ion));
      filter->SetSpacing(0.8);
      filter->SetPadding(padding);
      filter->SetBoundaryCondition(vtkPoissonBoltzmann::Zero);
      filter->Update();
      const double born = -0.5 * 332.0637 * charge * charge * (0.5 - 1.0 / 80.0) / 5.0;
      const double off = std::abs(Field(filter->GetOutput(), "SolvationEnergy") - born);
      EXPECT_GT(off, 2e-3 * std::abs(born)) << padding;
      EXPECT_GE(Field(filter->GetOutput(), "SolvationEnergyError"), off) << padding;
      EXPECT_LE(Field(filter->GetOutput(), "SolvationEnergyError"), 5.0 * off) << padding;
    }
  }
}

// The true surface of a mask is somewhere between its outermost nodes and the next.
TEST(PoissonBoltzmannFilter, TheErrorCoversThePlaceOfAMask)
{
  int covered = 0, all = 0;
  for (const double spacing : { 0.5, 0.8 })
  {
    for (double radius = 1.9; radius < 4.5; radius += 0.43)
    {
      KirkwoodSphere ion;
      ion.Center = { 1.1, -2.2, 3.3 };
      ion.Charges.push_back({ ion.Center, 1.0, radius });
      GridChoice choice;
      choice.Spacing = { spacing, spacing, spacing };
      vtkNew<vtkPoissonBoltzmann> filter;
      filter->SetInputDataObject(0, Atoms(ion));
      filter->SetInputDataObject(
        1, Volume(ion, choice, [=](double r) { return r < radius ? 1.0 : 0.0; }));
      filter->Update();
      const double born = -0.5 * 332.0637 * (0.5 - 1.0 / 80.0) / radius;
      const double off = std::abs(Field(filter->GetOutput(), "SolvationEnergy") - born);
      covered += Field(filter->GetOutput(), "SolvationEnergyError") >= off ? 1 : 0;
      ++all;
    }
  }
  EXPECT_GE(covered, 9 * all / 10) << all;
}

TEST(PoissonBoltzmannFilter, ADuplicateAtomCountsOnce)
{
  KirkwoodSphere ion;
  ion.Charges.push_back({ { 0.2, 0.1, -0.3 }, 1.0, 2.5 });
  vtkNew<vtkPoissonBoltzmann> filter;
  filter->SetInputDataObject(0, Atoms(ion));
  filter->SetPadding(4.0);
  filter->Update();
  const double energy = Field(filter->GetOutput(), "SolvationEnergy");
  ion.Charges.push_back({ ion.Charges.front().Position, 1.0, 2.0 });
  filter->SetInputDataObject(0, Atoms(ion));
  vtkNew<vtkTest::ErrorObserver> said;
  filter->AddObserver(vtkCommand::WarningEvent, said);
  filter->Update();
  EXPECT_EQ(Field(filter->GetOutput(), "SolvationEnergy"), energy);
  EXPECT_NE(said->GetWarningMessage().find("1 of 2 atoms lie exactly where another one lies"),
    std::string::npos);
  vtkDataArray* energies = filter->GetAtoms()->GetPointData()->GetArray("AtomEnergy");
  ASSERT_EQ(energies->GetNumberOfTuples(), 2);
  EXPECT_EQ(energies->GetTuple1(0), energy);
  EXPECT_EQ(energies->GetTuple1(1), 0.0);
}

TEST(PoissonBoltzmannFilter, FocusingTakesTheBorderFromInput2)
{
  const KirkwoodSphere sphere = Sphere();
  GridChoice wide;
  wide.Half = 16.0;
  wide.Spacing = { 1.0, 1.0, 1.0 };
  GridChoice narrow;
  narrow.Half = 8.0;
  vtkNew<vtkPoissonBoltzmann> outer, inner;
  outer->SetInputDataObject(0, Atoms(sphere));
  outer->SetInputDataObject(1, Volume(sphere, wide, Minus));
  outer->SetLevel(0.0);
  inner->SetInputDataObject(0, Atoms(sphere));
  inner->SetInputDataObject(1, Volume(sphere, narrow, Minus));
  inner->SetInputConnection(2, outer->GetOutputPort());
  inner->SetLevel(0.0);
  inner->SetBoundaryCondition(vtkPoissonBoltzmann::FromInput);
  inner->Update();
  EXPECT_LT(RecordErrors(inner, sphere).Outside, 0.15);
}

/// Runs a changed filter that must fail with an error message that contains `words`.
void ExpectError(
  const std::function<void(vtkPoissonBoltzmann*, vtkPolyData*)>& change, const char* words)
{
  const KirkwoodSphere sphere = Sphere();
  GridChoice choice;
  choice.Spacing = { 1.0, 1.0, 1.0 };
  const auto atoms = Atoms(sphere);
  vtkNew<vtkPoissonBoltzmann> filter;
  vtkNew<vtkTest::ErrorObserver> observer, executive;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
  filter->SetInputDataObject(0, atoms);
  filter->SetInputDataObject(1, Volume(sphere, choice, Minus));
  filter->SetLevel(0.0);
  change(filter, atoms);
  filter->Update();
  EXPECT_TRUE(observer->GetError()) << words;
  EXPECT_NE(observer->GetErrorMessage().find(words), std::string::npos)
    << observer->GetErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetSurface()->GetNumberOfPoints(), 0);
}

TEST(PoissonBoltzmannFilter, EveryRefusalHasAMessage)
{
  const double nan = vtkMath::Nan();
  using Filter = vtkPoissonBoltzmann*;
  const auto charges = [](vtkPolyData* atoms) { return atoms->GetPointData()->GetArray("Charge"); };
  ExpectError([&](Filter, vtkPolyData* a) { a->GetPointData()->RemoveArray("Charge"); }, "pdb2pqr");
  ExpectError(
    [&](Filter, vtkPolyData* a) { charges(a)->FillComponent(0, 0.0); }, "All charges are 0");
  ExpectError([&](Filter, vtkPolyData* a) { charges(a)->SetTuple1(1, nan); }, "charge of atom 1");
  ExpectError(
    [&](Filter, vtkPolyData* a) { a->GetPoints()->SetPoint(2, 0, 0, 0); }, "outside the surface");
  ExpectError([&](Filter, vtkPolyData* a)
    { a->GetPointData()->GetArray("Radius")->SetTuple1(0, -1.0); },
    "radius of atom 0");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetLevel(nan); }, "Level");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetInsideIsHigher(0); }, "surface");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetIonicStrength(nan); }, "IonicStrength");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetIonicStrength(-0.1); }, "IonicStrength");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetIonicStrength(150.0); }, "mol/l");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetTemperature(37.0); }, "kelvin");
  ExpectError(
    [&](Filter f, vtkPolyData*)
    {
      f->AddIon(1.0, 150.0);
      f->AddIon(-1.0, 150.0);
    },
    "from 0 to 10 mol/l");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetSoluteDielectric(0.0); }, "SoluteDielectric");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetPadding(-1.0); }, "Padding");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetPadding(9e5); }, "are available");
  ExpectError([&](Filter f, vtkPolyData*) { f->AddIon(2.0, 0.1); }, "neutral");
  ExpectError([&](Filter f, vtkPolyData*)
    { f->SetBoundaryCondition(vtkPoissonBoltzmann::FromInput); },
    "input 2");
  ExpectError([&](Filter f, vtkPolyData*) { f->SetMaximumIterations(1); }, "did not converge");
}

TEST(PoissonBoltzmannFilter, TooLargeAGridIsRefusedBeforeItsSurfaceIsMade)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(5.0);
  ball->SetCenter(Sphere().Center.data());
  ball->Update();
  for (vtkDataObject* surface :
    { static_cast<vtkDataObject*>(nullptr), ball->GetOutputDataObject(0) })
  {
    ExpectError(
      [&](vtkPoissonBoltzmann* filter, vtkPolyData*)
      {
        filter->SetInputDataObject(1, surface);
        filter->SetSpacing(0.01); // some 3000^3 nodes
      },
      "are available: choose a larger Spacing");
  }
}

TEST(PoissonBoltzmannFilter, AnAtomFarFromTheOthersIsRefusedBeforeAnythingIsSolved)
{
  // 50,000 nodes by 11 by 13 fit into memory.
  ExpectError(
    [&](vtkPoissonBoltzmann* filter, vtkPolyData* atoms)
    {
      double p[3];
      atoms->GetPoint(1, p);
      atoms->GetPoints()->SetPoint(1, p[0] + 1e5, p[1], p[2]);
      filter->SetInputDataObject(1, nullptr);
      filter->SetSpacing(2.0);
    },
    "Choose a Spacing of at least 5.05");
}

TEST(PoissonBoltzmannFilter, SurfacesThatCrossAreRefusedWithTheirPlace)
{
  const Point3 center = Sphere().Center;
  TriangleMesh both;
  for (const double offset : { 0.0, 6.0 }) // along x: they cross 3 from each center
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(5.0);
    ball->SetCenter(center[0] + offset, center[1], center[2]);
    ball->SetPhiResolution(30);
    ball->SetThetaResolution(30);
    ball->Update();
    const TriangleMesh one = ToTriangleMesh(ball->GetOutput());
    const auto first = static_cast<vtkIdType>(both.Points.size());
    both.Points.insert(both.Points.end(), one.Points.begin(), one.Points.end());
    for (const Triangle& t : one.Triangles)
    {
      both.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
  }
  vtkNew<vtkPolyData> surface;
  SetMesh(both, surface);
  ExpectError([&](vtkPoissonBoltzmann* filter, vtkPolyData*)
    { filter->SetInputDataObject(1, surface); },
    "cross at (103.");
}

TEST(PoissonBoltzmannFilter, AtomsThatTheGridCannotShowAreNamed)
{
  for (const double radius : { 0.1, 0.2, 0.4, 0.45 })
  {
    KirkwoodSphere ions;
    ions.Charges = { { { 0.1, 0.2, 0.3 }, 1.0, 2.0 }, { { 8.1, 0.2, 0.3 }, -1.0, radius } };
    vtkNew<vtkPoissonBoltzmann> filter;
    vtkNew<vtkTest::ErrorObserver> observer, executive;
    filter->AddObserver(vtkCommand::ErrorEvent, observer);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, executive);
    filter->SetInputDataObject(0, Atoms(ions));
    filter->Update();
    EXPECT_NE(observer->GetErrorMessage().find("atom 1"), std::string::npos)
      << radius << observer->GetErrorMessage();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(PoissonBoltzmannFilter, ErrorOfTheEnergyIsStated)
{
  const KirkwoodSphere ion = []
  {
    KirkwoodSphere s;
    s.Charges.push_back({ { 0.1, 0.2, 0.3 }, 1.0, 1.0 });
    return s;
  }();
  double errors[2];
  for (const double spacing : { 0.25, 0.8 })
  {
    vtkNew<vtkPoissonBoltzmann> filter;
    vtkNew<vtkTest::ErrorObserver> observer;
    filter->AddObserver(vtkCommand::WarningEvent, observer);
    filter->SetInputDataObject(0, Atoms(ion));
    filter->SetSpacing(spacing);
    filter->Update();
    const double born = -0.5 * 332.0637 * (0.5 - 1.0 / 80.0);
    const double stated = Field(filter->GetOutput(), "SolvationEnergyError");
    EXPECT_LT(std::abs(Field(filter->GetOutput(), "SolvationEnergy") - born), stated);
    EXPECT_EQ(observer->GetWarning(), spacing > 0.5);
    EXPECT_EQ(
      observer->GetWarningMessage().find("uncertain by about") != std::string::npos, spacing > 0.5);
    errors[spacing > 0.5 ? 1 : 0] = stated;
  }
  EXPECT_LT(errors[0], 0.02 * 80.9);
  EXPECT_GT(errors[1], 4.0);
}

TEST(PoissonBoltzmannFilter, NoAtomsNoError)
{
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkPoissonBoltzmann> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputDataObject(0, nothing);
  filter->Update();
  EXPECT_FALSE(observer->GetError());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

}
