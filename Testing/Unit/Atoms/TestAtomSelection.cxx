#include "vtkAtomSelection.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{

struct Atom
{
  const char* Name;
  const char* Residue;
  int ResidueId;
  int Element;
  int IsHetero;
};

/// Glycine with one hydrogen, a heme's iron and one of its nitrogens, an ion, a ligand of two
/// atoms, water with a hydrogen.
const std::vector<Atom> Atoms{ { "N", "GLY", 1, 7, 0 }, { "H", "GLY", 1, 1, 0 },
  { "CA", "GLY", 1, 6, 0 }, { "C", "GLY", 1, 6, 0 }, { "O", "GLY", 1, 8, 0 },
  { "FE", "HEM", 2, 26, 1 }, { "NA", "HEM", 2, 7, 1 }, { "ZN", "ZN", 3, 30, 1 },
  { "C1", "LIG", 4, 6, 1 }, { "O1", "LIG", 4, 8, 1 }, { "O", "HOH", 5, 8, 1 },
  { "H1", "HOH", 5, 1, 1 } };

/// The atoms 10 angstrom apart by residue, with vertices, bonds along the list inside of residues,
/// and one bond from the glycine to the ligand. The number of each cell is an array.
vtkSmartPointer<vtkPolyData> Molecule()
{
  auto molecule = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices, lines;
  vtkNew<vtkStringArray> names, residues, chains;
  vtkNew<vtkIntArray> ids, atomIds, cells;
  vtkNew<vtkUnsignedShortArray> elements;
  vtkNew<vtkUnsignedCharArray> hetero;
  for (const Atom& atom : Atoms)
  {
    const vtkIdType id = points->InsertNextPoint(
      10.0 * atom.ResidueId, 1.5 * static_cast<double>(points->GetNumberOfPoints()), 0.0);
    vertices->InsertNextCell(1, &id);
    if (id > 0 && ids->GetValue(id - 1) == atom.ResidueId)
    {
      const vtkIdType bond[2] = { id - 1, id };
      lines->InsertNextCell(2, bond);
    }
    names->InsertNextValue(atom.Name);
    residues->InsertNextValue(atom.Residue);
    chains->InsertNextValue("A");
    ids->InsertNextValue(atom.ResidueId);
    elements->InsertNextValue(static_cast<unsigned short>(atom.Element));
    hetero->InsertNextValue(static_cast<unsigned char>(atom.IsHetero));
    atomIds->InsertNextValue(static_cast<int>(100 + id));
  }
  const vtkIdType across[2] = { 3, 8 };
  lines->InsertNextCell(2, across);
  molecule->SetPoints(points);
  molecule->SetVerts(vertices);
  molecule->SetLines(lines);
  for (vtkIdType i = 0; i < molecule->GetNumberOfCells(); ++i)
  {
    cells->InsertNextValue(static_cast<int>(i));
  }
  vtkAbstractArray* const arrays[] = { names, residues, chains, ids, elements, hetero, atomIds };
  const char* const called[] = { "AtomName", "ResidueName", "Chain", "ResidueId", "Element",
    "IsHetero", "AtomId" };
  for (int a = 0; a < 7; ++a)
  {
    arrays[a]->SetName(called[a]);
    molecule->GetPointData()->AddArray(arrays[a]);
  }
  cells->SetName("Cell");
  molecule->GetCellData()->AddArray(cells);
  vtkNew<vtkStringArray> title;
  title->SetName("Title");
  title->InsertNextValue("test");
  molecule->GetFieldData()->AddArray(title);
  return molecule;
}

/// Ids of the selected atoms in the input, from the array AtomId.
std::vector<int> KeptAtomIds(const std::function<void(vtkAtomSelection*)>& set)
{
  vtkNew<vtkAtomSelection> filter;
  filter->SetInputDataObject(Molecule());
  set(filter);
  filter->Update();
  std::vector<int> kept;
  vtkPointSet* output = filter->GetOutput();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const auto id = output->GetPointData()->GetArray("AtomId")->GetTuple1(i);
    EXPECT_EQ(output->GetPoint(i)[1], 1.5 * (id - 100.0));
    kept.push_back(static_cast<int>(id) - 100);
  }
  return kept;
}

using Ids = std::vector<int>;

TEST(AtomSelection, EachSwitchAddsItsResidues)
{
  EXPECT_EQ(KeptAtomIds([](vtkAtomSelection*) {}), (Ids{ 0, 1, 2, 3, 4 }));
  EXPECT_EQ(
    KeptAtomIds([](vtkAtomSelection* f) { f->IncludeHydrogensOff(); }), (Ids{ 0, 2, 3, 4 }));
  EXPECT_EQ(KeptAtomIds([](vtkAtomSelection* f) { f->IncludeProstheticGroupsOn(); }),
    (Ids{ 0, 1, 2, 3, 4, 5, 6 }));
  EXPECT_EQ(
    KeptAtomIds([](vtkAtomSelection* f) { f->IncludeIonsOn(); }), (Ids{ 0, 1, 2, 3, 4, 7 }));
  EXPECT_EQ(KeptAtomIds([](vtkAtomSelection* f) { f->IncludeLigandsOn(); }),
    (Ids{ 0, 1, 2, 3, 4, 5, 6, 8, 9 }));
  EXPECT_EQ(
    KeptAtomIds([](vtkAtomSelection* f) { f->IncludeWatersOn(); }), (Ids{ 0, 1, 2, 3, 4, 10, 11 }));
  EXPECT_EQ(KeptAtomIds([](vtkAtomSelection* f) { f->SetIncludeResidues("ZN, LIG"); }),
    (Ids{ 0, 1, 2, 3, 4, 7, 8, 9 }));
}

TEST(AtomSelection, WithoutChainsTheRestIsKept)
{
  const auto rest = [](const std::function<void(vtkAtomSelection*)>& set)
  {
    return KeptAtomIds(
      [&](vtkAtomSelection* f)
      {
        f->IncludeChainsOff();
        set(f);
      });
  };
  EXPECT_EQ(rest([](vtkAtomSelection*) {}), Ids{});
  EXPECT_EQ(rest([](vtkAtomSelection* f) { f->IncludeLigandsOn(); }), (Ids{ 5, 6, 8, 9 }));
  EXPECT_EQ(rest(
              [](vtkAtomSelection* f)
              {
                f->IncludeWatersOn();
                f->IncludeHydrogensOff();
              }),
    Ids{ 10 });
  EXPECT_EQ(
    rest([](vtkAtomSelection* f) { f->SetIncludeResidues("GLY"); }), (Ids{ 0, 1, 2, 3, 4 }));
}

TEST(AtomSelection, BondsOfKeptAtomsStayWithTheirArrays)
{
  vtkNew<vtkAtomSelection> filter;
  filter->SetInputDataObject(Molecule());
  filter->IncludeChainsOff();
  filter->SetIncludeResidues("LIG");
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutput());
  ASSERT_NE(output, nullptr);
  ASSERT_EQ(output->GetNumberOfVerts(), 2);
  ASSERT_EQ(output->GetNumberOfLines(), 1); // without the bond to the glycine
  vtkDataArray* cells = output->GetCellData()->GetArray("Cell");
  // Of the input: vertices 8 and 9; bonds 12 to 15 in the glycine, 16 in the heme, 17 in the
  // ligand.
  EXPECT_EQ(cells->GetTuple1(0), 8.0);
  EXPECT_EQ(cells->GetTuple1(1), 9.0);
  EXPECT_EQ(cells->GetTuple1(2), 17.0);
  vtkNew<vtkIdList> ids;
  output->GetCellPoints(2, ids);
  EXPECT_EQ(ids->GetId(0), 0);
  EXPECT_EQ(ids->GetId(1), 1);
  vtkFieldData* field = output->GetFieldData();
  EXPECT_NE(field->GetAbstractArray("Title"), nullptr);
  ASSERT_NE(field->GetAbstractArray("Notes"), nullptr);
  const auto* notes = vtkStringArray::SafeDownCast(field->GetAbstractArray("Notes"));
  std::string all;
  for (vtkIdType i = 0; i < notes->GetNumberOfValues(); ++i)
  {
    all += const_cast<vtkStringArray*>(notes)->GetValue(i) + "\n";
  }
  for (const char* word : { "HEM", "ZN", "Chains of amino acids", "Water" })
  {
    EXPECT_NE(all.find(word), std::string::npos) << word << " in " << all;
  }
}

TEST(AtomSelection, OtherAndEmptyPointSetsKeepTheirType)
{
  vtkNew<vtkUnstructuredGrid> grid;
  const auto molecule = Molecule();
  grid->SetPoints(molecule->GetPoints());
  grid->GetPointData()->ShallowCopy(molecule->GetPointData());
  vtkNew<vtkAtomSelection> filter;
  filter->SetInputDataObject(grid);
  filter->Update();
  EXPECT_STREQ(filter->GetOutput()->GetClassName(), "vtkUnstructuredGrid");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 5);
  filter->SetInputDataObject(vtkSmartPointer<vtkPolyData>::New());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(AtomSelection, PositionsThatAreNotFiniteAreAnError)
{
  const auto molecule = Molecule();
  molecule->GetPoints()->SetPoint(4, std::nan(""), 0.0, 0.0);
  vtkNew<vtkAtomSelection> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetInputDataObject(molecule);
  filter->Update();
  EXPECT_NE(observer->GetErrorMessage().find("finite"), std::string::npos)
    << observer->GetErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

}
