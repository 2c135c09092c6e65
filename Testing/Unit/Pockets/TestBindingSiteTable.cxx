// The residues around a site: those within 4 angstrom of it, by name, and their order.

#include "vtkBindingSites.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

constexpr double radius = 10.0;

/// A sphere with a cap about +x and a smaller one about -x.
vtkSmartPointer<vtkPolyData> Caps()
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(200);
  source->SetPhiResolution(101);
  source->Update();
  vtkSmartPointer<vtkPolyData> sphere = source->GetOutput();
  vtkNew<vtkDoubleArray> value;
  value->SetName("PolarizedCurvature");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    const double x = sphere->GetPoint(i)[0];
    value->InsertNextValue(x > radius - 2.0 ? 3.0 : x < 1.0 - radius ? 3.0 : 0.0);
  }
  sphere->GetPointData()->AddArray(value);
  return sphere;
}

struct Atom
{
  double X;
  const char* Chain;
  const char* Residue;
  int ResidueId;
};

vtkSmartPointer<vtkPolyData> Molecule(const std::vector<Atom>& atoms, bool named = true)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  vtkNew<vtkStringArray> chains, residues;
  chains->SetName("Chain");
  residues->SetName("ResidueName");
  vtkNew<vtkIntArray> ids;
  ids->SetName("ResidueId");
  for (const Atom& atom : atoms)
  {
    points->InsertNextPoint(atom.X, 0.0, 0.0);
    radii->InsertNextValue(1.5);
    chains->InsertNextValue(atom.Chain);
    residues->InsertNextValue(atom.Residue);
    ids->InsertNextValue(atom.ResidueId);
  }
  auto molecule = vtkSmartPointer<vtkPolyData>::New();
  molecule->SetPoints(points);
  molecule->GetPointData()->AddArray(radii);
  if (named)
  {
    molecule->GetPointData()->AddArray(chains);
    molecule->GetPointData()->AddArray(residues);
    molecule->GetPointData()->AddArray(ids);
  }
  return molecule;
}

vtkSmartPointer<vtkTable> MakeTable(vtkPolyData* atoms)
{
  vtkNew<vtkBindingSites> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputData(Caps());
  if (atoms)
  {
    filter->SetAtomsData(atoms);
  }
  filter->SetUsePockets(false);
  filter->SetClasses(vtkBindingSites::AllPoints);
  filter->SetAutomaticThreshold(false);
  filter->Update();
  EXPECT_FALSE(observer->GetError()) << observer->GetErrorMessage();
  return filter->GetSiteTable();
}

std::string Residues(vtkTable* table, vtkIdType row)
{
  return table->GetValueByName(row, "Residues").ToString();
}

}

TEST(BindingSiteTable, ResiduesWithinFourAngstromMostAtomsFirst)
{
  const auto table = MakeTable(Molecule({ { 13.9, "A", "ALA", 7 }, { 14.1, "A", "GLY", 8 },
    { 12.0, "B", "HIS", 57 }, { 11.0, "B", "HIS", 57 }, { -13.9, "A", "ALA", 7 } }));
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  EXPECT_EQ(Residues(table, 0), "HIS 57 B (2); ALA 7 A (1)");
  EXPECT_EQ(Residues(table, 1), "ALA 7 A (1)");
}

TEST(BindingSiteTable, AtomsWithoutNamesAreCounted)
{
  const auto table =
    MakeTable(Molecule({ { 13.9, "", "", 0 }, { 12.0, "", "", 0 }, { -13.0, "", "", 0 } }, false));
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  EXPECT_EQ(Residues(table, 0), "2 atoms");
  EXPECT_EQ(Residues(table, 1), "1 atom");
}

TEST(BindingSiteTable, BeginsWithTheMostImportantColumns)
{
  const auto with = MakeTable(Molecule({ { 13.0, "A", "ALA", 7 } }));
  const char* const first[] = { "Rank", "Score", "SiteClass", "Class", "Residues" };
  for (int i = 0; i < 5; ++i)
  {
    EXPECT_STREQ(with->GetColumnName(i), first[i]);
  }
  EXPECT_EQ(with->GetColumnByName("Volume"), nullptr); // of pockets only
  EXPECT_EQ(MakeTable(nullptr)->GetColumnByName("Residues"), nullptr);
}
