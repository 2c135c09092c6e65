#include "vtkMoleculeCartoon.h"

#include "Atoms/MoleculeCartoon.h"

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

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{

using isthmus::NamedAtom;
using isthmus::PolymerResidue;
using isthmus::SecondaryStructure;
using isthmus::operator-;
using Atoms = std::vector<NamedAtom>;

NamedAtom AtomAt(const isthmus::Point3& place, const char* name, const char* residue, int number,
  int element, const char* chain = "A")
{
  NamedAtom atom;
  atom.Place = place;
  atom.Name = name;
  atom.Residue = residue;
  atom.ResidueId = number;
  atom.Element = element;
  atom.Chain = chain;
  return atom;
}

/// An ideal alpha helix around z: 1.5 angstrom and 100 degrees for each residue.
Atoms Helix(int residues, const char* chain = "A")
{
  struct Place
  {
    const char* Name;
    double Radius, Angle, Rise;
    int Element;
  };
  const std::vector<Place> places{ { "N", 1.55, -27.7, -0.9, 7 }, { "CA", 2.29, 0.0, 0.0, 6 },
    { "C", 1.66, 26.4, 1.13, 6 }, { "O", 1.99, 22.6, 2.33, 8 } };
  Atoms atoms;
  for (int r = 0; r < residues; ++r)
  {
    for (const Place& place : places)
    {
      const double angle = (100.0 * r + place.Angle) * isthmus::Pi / 180.0;
      atoms.push_back(AtomAt(
        { place.Radius * std::cos(angle), place.Radius * std::sin(angle), 1.5 * r + place.Rise },
        place.Name, "ALA", r + 1, place.Element, chain));
    }
  }
  return atoms;
}

std::vector<PolymerResidue> ResiduesOfAll(const Atoms& atoms)
{
  std::vector<std::size_t> all(atoms.size());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = i;
  }
  return isthmus::FindResidues(atoms, all);
}

/// One letter for each residue: C, H, E, G, I, N.
std::string FindStructure(const Atoms& atoms)
{
  std::string letters;
  for (const SecondaryStructure s : isthmus::FindSecondaryStructure(atoms, ResiduesOfAll(atoms)))
  {
    letters += "CHEGIN"[static_cast<std::size_t>(s)];
  }
  return letters;
}

isthmus::CartoonMesh Cartoon(const Atoms& atoms)
{
  const auto residues = ResiduesOfAll(atoms);
  isthmus::CartoonMesh mesh;
  isthmus::DrawCartoon(atoms, residues, isthmus::FindSecondaryStructure(atoms, residues), {}, mesh);
  return mesh;
}

void ExpectFinite(const isthmus::CartoonMesh& mesh)
{
  ASSERT_EQ(mesh.Points.size(), mesh.Normals.size());
  ASSERT_EQ(mesh.Offsets.size(), mesh.Items.size() + 1);
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    EXPECT_TRUE(std::isfinite(isthmus::Length(mesh.Points[i])));
    EXPECT_NEAR(isthmus::Length(mesh.Normals[i]), 1.0, 1e-6);
  }
  for (const std::int64_t corner : mesh.Corners)
  {
    EXPECT_GE(corner, 0);
    EXPECT_LT(corner, static_cast<std::int64_t>(mesh.Points.size()));
  }
}

isthmus::Point3 Corner(const isthmus::CartoonMesh& mesh, std::size_t polygon, std::int64_t k)
{
  return mesh.Points[static_cast<std::size_t>(
    mesh.Corners[static_cast<std::size_t>(mesh.Offsets[polygon] + k)])];
}

/// Fraction of polygons whose orientation agrees with their normals.
double ShareFacingOutward(const isthmus::CartoonMesh& mesh)
{
  double outward = 0.0;
  double all = 0.0;
  for (std::size_t p = 0; p < mesh.NumberOfPolygons(); ++p)
  {
    const isthmus::Point3 a = Corner(mesh, p, 0);
    const isthmus::Point3 n = isthmus::Cross(Corner(mesh, p, 1) - a, Corner(mesh, p, 2) - a);
    if (isthmus::Length(n) > 1e-4)
    {
      const auto first =
        static_cast<std::size_t>(mesh.Corners[static_cast<std::size_t>(mesh.Offsets[p])]);
      outward += isthmus::Dot(n, mesh.Normals[first]) > 0.0 ? 1.0 : 0.0;
      all += 1.0;
    }
  }
  return outward / all;
}

/// Largest or smallest z of the polygons of an item.
std::set<std::int64_t> ItemsBetween(const isthmus::CartoonMesh& mesh, double low, double high)
{
  std::set<std::int64_t> items;
  for (std::size_t p = 0; p < mesh.NumberOfPolygons(); ++p)
  {
    const double z = Corner(mesh, p, 0)[2];
    if (z > low && z < high)
    {
      items.insert(mesh.Items[p]);
    }
  }
  return items;
}

vtkSmartPointer<vtkPolyData> Molecule(
  const Atoms& atoms, const std::vector<std::array<vtkIdType, 2>>& bonds = {})
{
  auto molecule = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkStringArray> names, residues, chains;
  vtkNew<vtkIntArray> ids;
  vtkNew<vtkUnsignedShortArray> elements;
  vtkNew<vtkUnsignedCharArray> hetero;
  for (const NamedAtom& atom : atoms)
  {
    points->InsertNextPoint(atom.Place.data());
    names->InsertNextValue(atom.Name);
    residues->InsertNextValue(atom.Residue);
    chains->InsertNextValue(atom.Chain);
    ids->InsertNextValue(atom.ResidueId);
    elements->InsertNextValue(static_cast<unsigned short>(atom.Element));
    hetero->InsertNextValue(atom.IsHetero ? 1 : 0);
  }
  for (const auto& bond : bonds)
  {
    lines->InsertNextCell(2, bond.data());
  }
  molecule->SetPoints(points);
  molecule->SetLines(lines);
  vtkAbstractArray* const arrays[] = { names, residues, chains, ids, elements, hetero };
  const char* const called[] = { "AtomName", "ResidueName", "Chain", "ResidueId", "Element",
    "IsHetero" };
  for (int a = 0; a < 6; ++a)
  {
    arrays[a]->SetName(called[a]);
    molecule->GetPointData()->AddArray(arrays[a]);
  }
  return molecule;
}

void AddBFactors(vtkPolyData* molecule, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName("BFactor");
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  molecule->GetPointData()->AddArray(array);
}

std::string Text(vtkFieldData* data, const char* name, vtkIdType i)
{
  auto* array = vtkStringArray::SafeDownCast(data->GetAbstractArray(name));
  return array && i < array->GetNumberOfValues() ? array->GetValue(i) : std::string();
}

double Number(vtkFieldData* data, const char* name, vtkIdType i)
{
  vtkDataArray* array = data->GetArray(name);
  return array ? array->GetTuple1(i) : std::numeric_limits<double>::quiet_NaN();
}

}

TEST(SecondaryStructure, FindsAnIdealHelix)
{
  // Two consecutive turns from residues 1 and 2 on; the last ones have no partner.
  EXPECT_EQ(FindStructure(Helix(12)), "CHHHHHHHHHHC");
  EXPECT_EQ(FindStructure(Helix(4)), "CCCC");
}

TEST(SecondaryStructure, NeedsTheBackboneAndUnbrokenChains)
{
  Atoms noOxygen = Helix(12);
  noOxygen.erase(std::remove_if(noOxygen.begin(), noOxygen.end(),
                   [](const NamedAtom& a) { return a.Name == "O"; }),
    noOxygen.end());
  EXPECT_EQ(FindStructure(noOxygen), std::string(12, 'C'));
  Atoms broken = Helix(12);
  for (std::size_t i = 24; i < broken.size(); ++i)
  {
    broken[i].Place[2] += 3.0;
  }
  EXPECT_EQ(FindStructure(broken).substr(4, 4), "HCCH");
}

TEST(SecondaryStructure, ProlineGivesNoHydrogenBond)
{
  Atoms atoms = Helix(5);
  EXPECT_EQ(FindStructure(Helix(6)), "CHHHHC");
  atoms = Helix(6);
  for (NamedAtom& atom : atoms)
  {
    atom.Residue = atom.ResidueId == 5 ? "PRO" : atom.Residue;
  }
  EXPECT_EQ(FindStructure(atoms), std::string(6, 'C'));
}

TEST(MoleculeCartoon, HelixIsAClosedRibbonAroundItsAxis)
{
  const auto mesh = Cartoon(Helix(20));
  ExpectFinite(mesh);
  EXPECT_GT(ShareFacingOutward(mesh), 0.99);
  std::set<std::int64_t> items(mesh.Items.begin(), mesh.Items.end());
  EXPECT_EQ(items.size(), 20U);
  // Every edge of the tube has two polygons, apart from edges of the caps, which have points of
  // their own.
  std::map<std::pair<std::int64_t, std::int64_t>, int> edges;
  for (std::size_t p = 0; p < mesh.NumberOfPolygons(); ++p)
  {
    const auto first = static_cast<std::size_t>(mesh.Offsets[p]);
    const auto corners = static_cast<std::size_t>(mesh.Offsets[p + 1]) - first;
    for (std::size_t k = 0; k < corners; ++k)
    {
      const std::int64_t a = mesh.Corners[first + k];
      const std::int64_t b = mesh.Corners[first + (k + 1) % corners];
      ++edges[{ std::min(a, b), std::max(a, b) }];
    }
  }
  const auto open =
    std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 2; });
  EXPECT_EQ(open, 4 * 12); // both ends: the ring of the tube, and that of its cap
  double most = 0.0;
  for (const isthmus::Point3& p : mesh.Points)
  {
    most = std::max(most, std::hypot(p[0], p[1]));
  }
  EXPECT_GT(most, 2.29);
  EXPECT_LT(most, 2.29 + 0.5); // flat along the axis: half of its thickness, and the curve's error
}

TEST(MoleculeCartoon, GapsStayOpen)
{
  Atoms atoms = Helix(20);
  for (std::size_t i = 40; i < atoms.size(); ++i)
  {
    atoms[i].Place[2] += 12.0;
  }
  const auto mesh = Cartoon(atoms);
  ExpectFinite(mesh);
  const double last = 1.5 * 9;
  EXPECT_TRUE(ItemsBetween(mesh, last + 2.0, last + 1.5 + 10.0).empty());
  EXPECT_EQ(ItemsBetween(mesh, -100.0, last + 2.0).size(), 10U);
  EXPECT_EQ(ItemsBetween(mesh, last + 10.0, 100.0).size(), 10U);
}

TEST(MoleculeCartoon, ChainsOfOneNameOrTwoAreNotJoined)
{
  Atoms atoms = Helix(5, "A");
  for (NamedAtom atom : Helix(5, "B"))
  {
    atom.Place[2] += 7.5; // where the next residue of chain A would be
    atoms.push_back(atom);
  }
  const auto residues = ResiduesOfAll(atoms);
  ASSERT_EQ(residues.size(), 10U);
  EXPECT_TRUE(residues[3].IsLinked);
  EXPECT_FALSE(residues[4].IsLinked);
}

TEST(MoleculeCartoon, DrawsTracesSinglesAndIncompleteResidues)
{
  Atoms traces;
  for (int r = 0; r < 8; ++r)
  {
    traces.push_back(AtomAt({ 3.8 * r, r % 2 == 0 ? 0.0 : 0.9, 0.0 }, "CA", "GLY", r + 1, 6));
  }
  ExpectFinite(Cartoon(traces));
  EXPECT_EQ(ResiduesOfAll(traces).size(), 8U);
  EXPECT_TRUE(ResiduesOfAll(traces)[0].IsLinked);
  Atoms straight; // no binormal
  for (int r = 0; r < 5; ++r)
  {
    straight.push_back(AtomAt({ 3.8 * r, 0.0, 0.0 }, "CA", "GLY", r + 1, 6));
  }
  ExpectFinite(Cartoon(straight));
  ExpectFinite(Cartoon({ straight[0] }));
  EXPECT_GT(Cartoon({ straight[0] }).NumberOfPolygons(), 0U);
  ExpectFinite(Cartoon({ straight[0], straight[1] }));
  Atoms together = straight; // all atoms at one place
  for (NamedAtom& atom : together)
  {
    atom.Place = { 1.0, 1.0, 1.0 };
  }
  ExpectFinite(Cartoon(together));
  EXPECT_EQ(Cartoon({}).NumberOfPolygons(), 0U);
}

TEST(MoleculeCartoon, RepeatedNamesBeginAResidue)
{
  Atoms atoms = Helix(2);
  for (NamedAtom& atom : atoms)
  {
    atom.ResidueId = 1;
  }
  EXPECT_EQ(ResiduesOfAll(atoms).size(), 2U);
  // Two locations without a letter are one residue.
  Atoms doubled = Helix(1);
  for (const char* const name : { "CB", "CG", "CG" })
  {
    doubled.push_back(AtomAt({ 4.0, 0.0, 0.0 }, name, "ALA", 1, 6));
  }
  EXPECT_EQ(ResiduesOfAll(doubled).size(), 1U);
}

TEST(MoleculeCartoon, ClosedChainsAreClosed)
{
  Atoms ring;
  for (int r = 0; r < 8; ++r)
  {
    const double angle = 2.0 * isthmus::Pi * r / 8.0;
    ring.push_back(
      AtomAt({ 4.9 * std::cos(angle), 4.9 * std::sin(angle), 0.0 }, "CA", "GLY", r + 1, 6));
  }
  const auto mesh = Cartoon(ring);
  ExpectFinite(mesh);
  const bool between = std::any_of(mesh.Points.begin(), mesh.Points.end(),
    [](const isthmus::Point3& p)
    {
      const double angle = std::atan2(p[1], p[0]); // halfway from the last residue to the first
      return std::abs(angle + isthmus::Pi / 8.0) < 0.05;
    });
  EXPECT_TRUE(between);
  ring.pop_back();
  const auto open = Cartoon(ring);
  EXPECT_TRUE(std::none_of(open.Points.begin(), open.Points.end(),
    [](const isthmus::Point3& p)
    { return std::abs(std::atan2(p[1], p[0]) + isthmus::Pi / 4.0) < 0.2; }));
}

TEST(MoleculeCartoon, StrandsEndInArrows)
{
  Atoms atoms;
  for (int r = 0; r < 10; ++r)
  {
    atoms.push_back(AtomAt({ 0.0, r % 2 == 0 ? 0.0 : 0.9, 3.3 * r }, "CA", "GLY", r + 1, 6));
  }
  const auto residues = ResiduesOfAll(atoms);
  std::vector<SecondaryStructure> structure(10, SecondaryStructure::Coil);
  std::fill(structure.begin() + 2, structure.begin() + 8, SecondaryStructure::Strand);
  isthmus::CartoonMesh mesh;
  isthmus::DrawCartoon(atoms, residues, structure, {}, mesh);
  ExpectFinite(mesh);
  EXPECT_GT(ShareFacingOutward(mesh), 0.99);
  const auto width = [&mesh](double low, double high)
  {
    double most = 0.0;
    for (const isthmus::Point3& p : mesh.Points)
    {
      most = p[2] > low && p[2] < high ? std::max(most, std::abs(p[0])) : most;
    }
    return most;
  };
  const double head = 3.3 * 6; // residue 7 of 10, the last but one of the strand
  EXPECT_NEAR(width(3.3 * 3.5, 3.3 * 5.5), 1.2, 0.05);
  EXPECT_NEAR(width(head - 0.3, head + 0.3), 1.2 * 1.6, 0.05);
  EXPECT_NEAR(width(3.3 * 7 + 0.3, 100.0), 0.25, 0.1);
}

TEST(MoleculeCartoon, NucleicAcidsAreTubesWithBases)
{
  Atoms atoms;
  for (int r = 0; r < 4; ++r)
  {
    const double z = 3.4 * r;
    const char* const name = r % 2 == 0 ? "DA" : "DC";
    atoms.push_back(AtomAt({ 8.0, 1.0, z - 1.0 }, "P", name, r + 1, 15));
    atoms.push_back(AtomAt({ 7.0, 0.0, z }, "C4'", name, r + 1, 6));
    if (r % 2 == 0)
    {
      atoms.push_back(AtomAt({ 5.0, 0.0, z }, "N9", name, r + 1, 7));
    }
    atoms.push_back(AtomAt({ 2.0, 0.0, z }, "N1", name, r + 1, 7));
    atoms.push_back(AtomAt({ 1.0, 0.0, z }, "N3", name, r + 1, 7));
  }
  EXPECT_EQ(FindStructure(atoms), "NNNN");
  const auto mesh = Cartoon(atoms);
  ExpectFinite(mesh);
  const auto end = [&mesh](std::int64_t item)
  {
    double least = 100.0;
    for (std::size_t p = 0; p < mesh.NumberOfPolygons(); ++p)
    {
      least = mesh.Items[p] == item ? std::min(least, Corner(mesh, p, 0)[0]) : least;
    }
    return least;
  };
  EXPECT_NEAR(end(0), 2.0 - 0.3, 0.1); // N1 of the purine
  EXPECT_NEAR(end(1), 1.0 - 0.3, 0.1); // N3 of the pyrimidine
}

TEST(MoleculeCartoon, OutputsHaveTheArraysForColoursAndTables)
{
  Atoms atoms = Helix(8);
  atoms.push_back(AtomAt({ 10.0, 0.0, 0.0 }, "C1", "LIG", 100, 6, "B"));
  atoms.push_back(AtomAt({ 11.4, 0.0, 0.0 }, "O1", "LIG", 100, 8, "B"));
  atoms.push_back(AtomAt({ 20.0, 0.0, 0.0 }, "ZN", "ZN", 101, 30, "B"));
  atoms.push_back(AtomAt({ 30.0, 0.0, 0.0 }, "O", "HOH", 102, 8, "B"));
  for (std::size_t i = 32; i < atoms.size(); ++i)
  {
    atoms[i].IsHetero = true;
  }
  auto molecule = Molecule(atoms, { { 0, 1 }, { 1, 2 }, { 32, 33 } });
  std::vector<double> factors(atoms.size(), 10.0);
  factors[0] = 30.0;
  factors[1] = std::numeric_limits<double>::quiet_NaN();
  AddBFactors(molecule, factors);
  vtkNew<vtkMoleculeCartoon> filter;
  filter->SetInputData(molecule);
  filter->Update();
  vtkPolyData* const table = filter->GetResidues();
  ASSERT_EQ(table->GetNumberOfPoints(), 10); // without water
  vtkPointData* const rows = table->GetPointData();
  EXPECT_EQ(Text(rows, "Residue", 0), "ALA 1 A");
  EXPECT_EQ(Text(rows, "Residue", 8), "LIG 100 B");
  EXPECT_EQ(Text(rows, "Chain", 9), "B");
  EXPECT_EQ(Number(rows, "ChainIndex", 9), 1.0);
  EXPECT_EQ(Number(rows, "SecondaryStructure", 3), 1.0);
  EXPECT_DOUBLE_EQ(Number(rows, "BFactor", 0), 50.0 / 3.0);
  EXPECT_NEAR(table->GetPoint(0)[0], atoms[1].Place[0], 1e-6); // CA
  EXPECT_NEAR(table->GetPoint(8)[0], 10.7, 1e-5);              // the middle
  EXPECT_EQ(Text(table->GetFieldData(), "ChainNames", 1), "B");

  vtkCellData* const cells = filter->GetOutput()->GetCellData();
  for (vtkIdType p = 0; p < filter->GetOutput()->GetNumberOfCells(); ++p)
  {
    const auto row = static_cast<vtkIdType>(Number(cells, "ResidueIndex", p));
    ASSERT_LT(row, 8);
    EXPECT_EQ(Text(cells, "Residue", p), Text(rows, "Residue", row));
    EXPECT_EQ(Number(cells, "SecondaryStructure", p), Number(rows, "SecondaryStructure", row));
    EXPECT_EQ(Number(cells, "BFactor", p), Number(rows, "BFactor", row));
  }

  vtkCellData* const sticks = filter->GetSticks()->GetCellData();
  std::set<double> elements;
  for (vtkIdType p = 0; p < filter->GetSticks()->GetNumberOfCells(); ++p)
  {
    elements.insert(Number(sticks, "Element", p));
    EXPECT_GE(Number(sticks, "ResidueIndex", p), 8.0);
  }
  EXPECT_EQ(elements, (std::set<double>{ 6, 8, 30 }));
  EXPECT_EQ(filter->GetSticks()->GetNumberOfCells(), 3 * 320 + 2 * 12);

  filter->IncludeIonsOff();
  filter->IncludeWatersOn();
  filter->Update();
  EXPECT_EQ(Text(filter->GetResidues()->GetPointData(), "Residue", 9), "HOH 102 B");
  filter->IncludeLigandsOff();
  filter->IncludeWatersOff();
  filter->Update();
  EXPECT_EQ(filter->GetSticks()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetResidues()->GetNumberOfPoints(), 8);
}

TEST(MoleculeCartoon, ListedResiduesAreSticksToo)
{
  auto molecule = Molecule(Helix(8), { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 2, 4 } });
  vtkNew<vtkMoleculeCartoon> filter;
  filter->SetInputData(molecule);
  filter->SetBallScale(0.0);
  const auto drawn = [&filter](const char* list)
  {
    filter->SetStickResidues(list);
    filter->Update();
    return filter->GetSticks()->GetNumberOfCells();
  };
  EXPECT_EQ(drawn(""), 0);
  EXPECT_EQ(drawn("1"), 4 * 320 + 6 * 12);
  EXPECT_EQ(drawn("A:1"), 4 * 320 + 6 * 12);
  EXPECT_EQ(drawn("B:1"), 0);
  EXPECT_EQ(drawn("1, 2"), 8 * 320 + 8 * 12);
  EXPECT_EQ(drawn("ALA"), 32 * 320 + 8 * 12);
}

TEST(MoleculeCartoon, UsesTheSecondaryStructureOfTheFile)
{
  auto molecule = Molecule(Helix(8));
  vtkNew<vtkUnsignedCharArray> given;
  given->SetName("SecondaryStructure");
  for (int i = 0; i < 32; ++i)
  {
    given->InsertNextValue(i < 16 ? 2 : i < 20 ? 200 : 3);
  }
  molecule->GetPointData()->AddArray(given);
  vtkNew<vtkMoleculeCartoon> filter;
  filter->SetInputData(molecule);
  filter->Update();
  const auto structure = [&filter](vtkIdType row)
  { return Number(filter->GetResidues()->GetPointData(), "SecondaryStructure", row); };
  EXPECT_EQ(structure(0), 2.0);
  EXPECT_EQ(structure(4), 0.0); // no such value
  EXPECT_EQ(structure(7), 3.0);
  filter->ComputeSecondaryStructureOn();
  filter->Update();
  EXPECT_EQ(structure(3), 1.0);
  EXPECT_EQ(structure(0), 0.0);
}

TEST(MoleculeCartoon, WithoutNamesAllAtomsAreBallsAndSticks)
{
  auto molecule = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.5, 0.0, 0.0);
  molecule->SetPoints(points);
  vtkNew<vtkMoleculeCartoon> filter;
  filter->SetInputData(molecule);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_EQ(filter->GetSticks()->GetNumberOfCells(), 2 * 320);
}

TEST(MoleculeCartoon, RefusesMeaninglessValues)
{
  vtkNew<vtkMoleculeCartoon> filter;
  vtkNew<vtkTest::ErrorObserver> errors;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  const vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  filter->Update();
  EXPECT_FALSE(errors->GetError());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  Atoms atoms = Helix(8);
  const auto fails = [&](const char* word)
  {
    filter->SetInputData(Molecule(atoms));
    filter->Update();
    EXPECT_NE(errors->GetErrorMessage().find(word), std::string::npos);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(filter->GetResidues()->GetNumberOfPoints(), 0);
    errors->Clear();
  };
  filter->SetRibbonWidth(0.0);
  fails("RibbonWidth");
  filter->SetRibbonWidth(2.4);
  filter->SetRibbonThickness(-1.0);
  fails("RibbonThickness");
  filter->SetRibbonThickness(0.5);
  filter->SetStickRadius(std::numeric_limits<double>::quiet_NaN());
  fails("StickRadius");
  filter->SetStickRadius(0.2);
  filter->SetBallScale(-0.1);
  fails("BallScale");
  filter->SetBallScale(0.25);
  atoms[3].Place[1] = std::numeric_limits<double>::infinity();
  fails("finite");
}
