// vtkIonTransport: a pore with the resistance of a cylinder, currents that vanish at Nernst's
// potentials, and the rectification of a dilute salt.

#include "vtkIonTransport.h"
#include "vtkIonTransportMovingSurface.h"

#include "ChannelTube.h"
#include "ChargedPoints.h"
#include "Core/PolyDataTriangles.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMatrix3x3.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// kT/e at 298.15 K in mV.
const double Thermal = 1e3 * units::BoltzmannConstant * 298.15 / units::ElementaryCharge;

double FieldNumber(vtkIonTransport* filter, const char* name)
{
  return filter->GetOutput()->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

double Cell(vtkTable* table, vtkIdType row, const char* column)
{
  return table->GetValueByName(row, column).ToDouble();
}

/// A filter on a tube of charged atoms in a thin membrane, `below` and `above` mol/l of KCl.
template <typename Filter = vtkIonTransport>
vtkSmartPointer<Filter> TubeInElectrolyte(double charge, double below, double above)
{
  constexpr double radius = 2.5;
  const IonTransportParameters p = TubeParameters(radius);
  const Tube tube = MakeTube(p, radius, charge);
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(
    ChargedPoints(tube.Balls, std::vector<double>(tube.Balls.size(), charge), 0.1));
  filter->SetMembraneThickness(p.MembraneThickness);
  filter->SetLumenRadius(p.LumenRadius);
  filter->SetSpacing(p.Spacing);
  filter->SetPadding(p.Padding);
  filter->ClearSpecies();
  filter->AddSpecies(1.0, below, above, 1.96);
  filter->AddSpecies(-1.0, below, above, 2.03);
  return filter;
}

}

// The rim of the hole lies within the tube of atoms or beyond it.
TEST(IonTransport, WarnsIfIonsPassBesideTheMolecule)
{
  const auto says = [](vtkSmartPointer<vtkIonTransport> filter, double lumen)
  {
    filter->SetLumenRadius(lumen);
    std::string said;
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(&said);
    note->SetCallback([](vtkObject*, unsigned long, void* all, void* text)
      { *static_cast<std::string*>(all) += static_cast<const char*>(text); });
    filter->AddObserver(vtkCommand::WarningEvent, note);
    filter->Update();
    return said.find("rim lies within the molecule") != std::string::npos;
  };
  for (const double lumen : { 3.0, 3.5, 4.4, 5.0, 9.0, 14.0 })
  {
    EXPECT_EQ(says(TubeInElectrolyte(0.0, 0.1, 0.1), lumen), lumen > 6.0) << lumen;
  }
  for (const double lumen : { 4.4, 9.0 })
  {
    const auto moving = TubeInElectrolyte<vtkIonTransportMovingSurface>(0.0, 0.1, 0.1);
    moving->SetMaximumUpdates(2);
    EXPECT_EQ(says(moving, lumen), lumen > 6.0) << lumen;
  }
}

TEST(IonTransport, CurrentOfAPoreFollowsOhmsLaw)
{
  // One atom without a charge, hidden in the membrane. Resistances of the pore, of the access to it
  // from both sides (J. E. Hall, J. Gen. Physiol. 66 (1975) 531, in a cylinder of finite width) and
  // of the baths.
  constexpr double pore = 4.0, thickness = 16.0, padding = 8.0, salt = 0.5, voltage = 25.0;
  vtkNew<vtkIonTransport> filter;
  filter->SetInputData(ChargedPoints({ { { 7.0, 0.0, 0.0 }, 1.7 } }, { 0.0 }, 0.1));
  filter->SetMembraneThickness(thickness);
  filter->SetLumenRadius(pore);
  filter->SetPadding(padding);
  filter->SetSpacing(1.0);
  filter->SetVoltage(voltage);
  filter->ClearSpecies();
  filter->AddSpecies(1.0, salt, salt, 1.96);
  filter->AddSpecies(-1.0, salt, salt, 2.03);
  filter->Update();
  const double cylinder = 7.0 + 1.7 + padding;
  const double e = pore / cylinder;
  const double access = 2.0 * 0.8217 * (1.0 - 1.409 * e + 0.296 * e * e * e) / (Pi * pore);
  const double resistance = thickness / (Pi * pore * pore) + access +
    2.0 * padding / (Pi * cylinder * cylinder); // 1/angstrom
  // D z^2 e^2 c V / kT: mol/l in ions a cubic angstrom, 1e-9 m^2/s in 1e11 square angstrom a
  // second.
  const double pico = 1e12 * units::ElementaryCharge * 1e11 * units::IonsPerCubicAngstrom;
  const double ohm = salt * voltage / Thermal * pico / resistance;
  EXPECT_NEAR(FieldNumber(filter, "Current") / ((1.96 + 2.03) * ohm), 1.0, 0.02);
  EXPECT_NEAR(FieldNumber(filter, "Current_K") / (1.96 * ohm), 1.0, 0.02);
  EXPECT_NEAR(FieldNumber(filter, "Current_Cl") / (2.03 * ohm), 1.0, 0.02);
  EXPECT_EQ(FieldNumber(filter, "Converged"), 1.0);
  EXPECT_EQ(FieldNumber(filter, "Voltage"), voltage);
  EXPECT_NEAR(FieldNumber(filter, "BottleneckRadius"), pore, 0.5);

  vtkTable* sections = filter->GetSections();
  ASSERT_GT(sections->GetNumberOfRows(), 20);
  for (vtkIdType row = 0; row < sections->GetNumberOfRows(); ++row)
  {
    ASSERT_NEAR(Cell(sections, row, "Current") / FieldNumber(filter, "Current"), 1.0, 1e-4);
  }

  // On the axis the potential falls from the bath below to that above, with half of it in the
  // middle, where the current density is that of the pore.
  vtkImageData* image = filter->GetOutput();
  const auto at = [image](double z, const char* name, int component = 0)
  {
    double place[3] = { 0.0, 0.0, z };
    return image->GetPointData()->GetArray(name)->GetComponent(image->FindPoint(place), component);
  };
  const double far = 0.5 * thickness + padding;
  EXPECT_NEAR(at(-far, "Potential"), voltage / Thermal, 1e-6);
  EXPECT_NEAR(at(0.0, "Potential"), 0.5 * voltage / Thermal, 0.01);
  EXPECT_NEAR(at(far, "Potential"), 0.0, 1e-6);
  for (const double z : { -far, far })
  {
    EXPECT_NEAR(at(z, "Concentration_K"), salt, 1e-5);
    EXPECT_NEAR(at(z, "Concentration_Cl"), salt, 1e-5);
  }
  const double density = FieldNumber(filter, "Current") / (Pi * pore * pore);
  EXPECT_NEAR(at(0.0, "CurrentDensity", 2) / density, 1.0, 0.05);
  EXPECT_EQ(at(0.0, "SignedDistance") > 0.0, true);
}

TEST(IonTransport, ObliqueChannelsHaveAnImageAlongTheAxes)
{
  constexpr double pore = 4.0, thickness = 16.0, padding = 8.0; // nodes on the walls
  const Point3 normal{ 2.0 / 7.0, -6.0 / 7.0, 3.0 / 7.0 };
  const Point3 center{ 30.3, -8.2, 4.9 };
  const auto along = [&](double z)
  {
    return Point3{ center[0] + z * normal[0], center[1] + z * normal[1],
      center[2] + z * normal[2] };
  };
  double straight = 0.0;
  for (const bool turned : { false, true })
  {
    vtkNew<vtkIonTransport> filter;
    filter->SetMembraneThickness(thickness);
    filter->SetLumenRadius(pore);
    filter->SetPadding(padding);
    filter->SetSpacing(1.0);
    Point3 atom{ 8.0, 0.0, 0.0 }; // uncharged, hidden in the membrane
    if (turned)
    {
      filter->SetMembraneCenter(center.data());
      filter->SetMembraneNormal(normal.data());
      atom = { center[0] + 6.0 * 8.0 / std::sqrt(40.0), center[1] + 2.0 * 8.0 / std::sqrt(40.0),
        center[2] };
    }
    filter->SetInputData(ChargedPoints({ { atom, 1.7 } }, { 0.0 }, 0.1));
    filter->Update();
    vtkImageData* const image = filter->GetOutput();
    const double current = FieldNumber(filter, "Current");
    if (!turned)
    {
      straight = current;
      continue;
    }
    EXPECT_NEAR(current / straight, 1.0, 1e-4); // sections differ by this much
    EXPECT_TRUE(image->GetDirectionMatrix()->IsIdentity());
    int extent[6];
    filter->GetOutputInformation(0)->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
    EXPECT_TRUE(std::equal(extent, extent + 6, image->GetExtent()));

    const auto at = [&](double z, const char* name, int component = 0)
    {
      return image->GetPointData()->GetArray(name)->GetComponent(
        image->FindPoint(along(z).data()), component);
    };
    const double far = 0.5 * thickness + padding;
    const double volt = filter->GetVoltage() / Thermal;
    constexpr double near = 0.05; // of the voltage: the next node is up to 0.87 angstrom off
    EXPECT_NEAR(at(-far, "Potential"), volt, near * volt);
    EXPECT_NEAR(at(0.0, "Potential"), 0.5 * volt, near * volt);
    EXPECT_NEAR(at(far, "Potential"), 0.0, near * volt);
    for (const double z : { -5.0, 0.0, 5.0 })
    {
      const Point3 density{ at(z, "CurrentDensity", 0), at(z, "CurrentDensity", 1),
        at(z, "CurrentDensity", 2) };
      const double size = Dot(density, normal);
      EXPECT_NEAR(size / (current / (Pi * pore * pore)), 1.0, 0.05) << z;
      for (std::size_t a = 0; a < 3; ++a)
      {
        EXPECT_NEAR(density[a], size * normal[a], 0.02 * size) << z;
      }
    }
  }
}

TEST(IonTransport, CurrentsVanishAtNernstsPotentials)
{
  // For any charges of the wall: c exp(z V) is equal in both baths there.
  const auto filter = TubeInElectrolyte(-0.05, 0.3, 0.1);
  const double nernst = Thermal * std::log(0.3 / 0.1);
  filter->SetVoltage(-nernst);
  filter->Update();
  const double lowPotassium = FieldNumber(filter, "Current_K");
  const double chloride = FieldNumber(filter, "Current_Cl");
  filter->SetVoltage(nernst);
  filter->Update();
  const double potassium = FieldNumber(filter, "Current_K");
  EXPECT_GT(potassium, 1.0); // up, with field and slope
  EXPECT_LT(chloride, -0.1); // anions up: a current down
  EXPECT_NEAR(lowPotassium, 0.0, 1e-5 * potassium);
  EXPECT_NEAR(FieldNumber(filter, "Current_Cl"), 0.0, -1e-5 * chloride);
  EXPECT_NEAR(FieldNumber(filter, "Current"), potassium, 1e-4 * potassium);
}

TEST(IonTransport, DiluteElectrolytesRectifyAsPredicted)
{
  // With very few ions the potential is that of voltage and charges alone, so that the current
  // is proportional to c_below exp(z V) - c_above.
  const auto current = [](double below, double above, const char* name)
  {
    const auto filter = TubeInElectrolyte(-0.05, below, above);
    filter->SetVoltage(50.0);
    filter->Update();
    return FieldNumber(filter, name);
  };
  const double drop = 50.0 / Thermal;
  for (const double z : { 1.0, -1.0 })
  {
    const char* name = z > 0.0 ? "Current_K" : "Current_Cl";
    const double most = std::exp(z * drop);
    EXPECT_NEAR(current(3e-6, 1e-6, name) / current(1e-6, 3e-6, name),
      (3.0 * most - 1.0) / (most - 3.0), 1e-3 * std::abs((3.0 * most - 1.0) / (most - 3.0)))
      << name;
  }
}

TEST(IonTransport, AClosedMembraneIsRefusedWithItsPlace)
{
  const auto filter = TubeInElectrolyte(-0.05, 0.1, 0.1);
  vtkNew<vtkTest::ErrorObserver> said;
  filter->AddObserver(vtkCommand::ErrorEvent, said);
  filter->SetLumenRadius(0.0);
  filter->Update();
  EXPECT_NE(said->GetErrorMessage().find("blocked at ("), std::string::npos)
    << said->GetErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetSections()->GetNumberOfRows(), 0);
}

TEST(IonTransport, SurfacesThatCrossAreRefusedWithTheirPlace)
{
  const auto filter = TubeInElectrolyte(-0.05, 0.1, 0.1);
  TriangleMesh boxes;
  for (const double low : { -4.0, -1.0 }) // along the axis; they overlap from -1 to 3
  {
    const auto first = static_cast<vtkIdType>(boxes.Points.size());
    for (int i = 0; i < 8; ++i)
    {
      boxes.Points.push_back(
        { i & 1 ? 6.0 : 4.0 + 0.1 * low, i & 2 ? 1.5 : -1.5 + 0.1 * low, i & 4 ? low + 7.0 : low });
    }
    for (const Triangle& t :
      { Triangle{ 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
        { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } })
    {
      boxes.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
    }
  }
  vtkNew<vtkPolyData> surface;
  SetMesh(boxes, surface);
  filter->SetInputData(1, surface);
  vtkNew<vtkTest::ErrorObserver> said;
  filter->AddObserver(vtkCommand::ErrorEvent, said);
  filter->Update();
  EXPECT_NE(said->GetErrorMessage().find("cross at ("), std::string::npos)
    << said->GetErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

// The surface of the same tube in nanometres lies within the tube, so the overlap is complete, but
// the charges are in the water: this once gave the current of a hole in the membrane.
TEST(IonTransport, ChargesOutsideTheSurfaceAreErrorsOrWarnings)
{
  const auto filter = TubeInElectrolyte(-0.05, 0.1, 0.1);
  const auto surface = [](double low, double high)
  {
    TriangleMesh box;
    for (int i = 0; i < 8; ++i)
    {
      box.Points.push_back({ i & 1 ? high : low, i & 2 ? high : low, i & 4 ? high : low });
    }
    for (const Triangle& t :
      { Triangle{ 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
        { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } })
    {
      box.Triangles.push_back(t);
    }
    auto result = vtkSmartPointer<vtkPolyData>::New();
    SetMesh(box, result);
    return result;
  };
  vtkNew<vtkTest::ErrorObserver> said;
  filter->AddObserver(vtkCommand::ErrorEvent, said);
  filter->AddObserver(vtkCommand::WarningEvent, said);
  filter->SetInputData(1, surface(-1.0, 1.0));
  filter->Update();
  EXPECT_NE(
    said->GetErrorMessage().find("charged atoms lie outside the surface"), std::string::npos)
    << said->GetErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  // Atoms without charges, as in a pore of carbon, were once not checked either.
  const auto neutral = TubeInElectrolyte(0.0, 0.1, 0.1);
  vtkNew<vtkTest::ErrorObserver> saidOfNeutral;
  neutral->AddObserver(vtkCommand::ErrorEvent, saidOfNeutral);
  neutral->AddObserver(vtkCommand::WarningEvent, saidOfNeutral);
  neutral->SetInputData(1, surface(-1.0, 1.0));
  neutral->Update();
  EXPECT_NE(
    saidOfNeutral->GetErrorMessage().find("atoms lie outside the surface"), std::string::npos)
    << saidOfNeutral->GetErrorMessage();
  EXPECT_EQ(neutral->GetOutput()->GetNumberOfPoints(), 0);
}
