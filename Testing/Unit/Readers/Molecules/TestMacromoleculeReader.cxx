// Selections, conformers and assemblies of small molecules, and the vtk class. Real files are read
// by Testing/Python/MacromoleculeReader.py, beside gemmi.

#include "MoleculeTexts.h"
#include "Molecules/MacromoleculeReader.h"
#include "TemporaryFile.h"
#include "vtkMacromoleculeReader.h"

#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkMolecule.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

struct Reading
{
  Reading()
  {
    this->Reader->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Reader->AddObserver(vtkCommand::WarningEvent, this->Observer);
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Pipeline);
  }
  vtkPolyData* Read(const std::string& path)
  {
    this->Reader->SetFileName(path.c_str());
    this->Reader->Update();
    return this->Reader->GetOutput();
  }
  vtkNew<vtkMacromoleculeReader> Reader;
  vtkNew<vtkTest::ErrorObserver> Observer, Pipeline;
};

}

TEST(MacromoleculeReader, Selections)
{
  MoleculeOptions options;
  options.AltLoc = "A";
  EXPECT_EQ(JoinNames(ParseMolecule(SmallPDB, MoleculeFormat::PDB, options)), "CA CBA OGA FE O ");
  options.AltLoc = "*";
  const Macromolecule all = ParseMolecule(SmallPDB, MoleculeFormat::PDB, options);
  EXPECT_EQ(JoinNames(all), "CA CBA CBB OGA OGB FE O ");
  // CA to both CB, each CB to its own OG: never one conformer to the other; Fe-O of the file.
  EXPECT_EQ(all.Bonds.size(), 5u);
  options.AltLoc.clear();
  options.Chains = " B,C";
  EXPECT_EQ(JoinNames(ParseMolecule(SmallPDB, MoleculeFormat::PDB, options)), "FE O ");
  options.ReadWater = false;
  const Macromolecule iron = ParseMolecule(SmallPDB, MoleculeFormat::PDB, options);
  EXPECT_EQ(JoinNames(iron), "FE ");
  EXPECT_TRUE(iron.Bonds.empty()); // its partner is gone
  options.ReadHetero = false;
  EXPECT_TRUE(ParseMolecule(SmallPDB, MoleculeFormat::PDB, options).Atoms.empty());
  options = MoleculeOptions();
  options.ModelIndex = 1;
  EXPECT_EQ(ParseMolecule(SmallPDB, MoleculeFormat::PDB, options).Atoms.at(0).Position[0], 5.0);
  options.RadiusTable = RadiusTable::Alvarez;
  options.ModelIndex = 0;
  EXPECT_TRUE(ParseMolecule(SmallPDB, MoleculeFormat::PDB, options).Warnings.empty());

  options = MoleculeOptions();
  options.Chains = "A X";
  EXPECT_EQ(
    CatchMessage(SmallPDB, MoleculeFormat::PDB, options), "There is no chain X; there are: A B C.");
  options = MoleculeOptions();
  options.AltLoc = "Q";
  EXPECT_NE(
    CatchMessage(SmallPDB, MoleculeFormat::PDB, options).find("location Q"), std::string::npos);
  options.AltLoc = "AB";
  EXPECT_NE(
    CatchMessage(SmallPDB, MoleculeFormat::PDB, options).find("one letter"), std::string::npos);
  options = MoleculeOptions();
  options.ModelIndex = 2;
  EXPECT_EQ(CatchMessage(SmallPDB, MoleculeFormat::PDB, options),
    "test: there is no model 2, they are numbered 0 to 1.");
}

TEST(MacromoleculeReader, ConformersAreComplete)
{
  // Equal occupancies: the first letter. An atom that only the other conformer has is kept, unless
  // the conformers are two different residues (1EN2 has such).
  const char* const residue =
    "ATOM      1  CB ASER A  10       0.000   0.000   0.000  0.50 10.00           C  \n"
    "ATOM      2  CB BSER A  10       1.000   0.000   0.000  0.50 10.00           C  \n"
    "ATOM      3  OG BSER A  10       3.000   0.000   0.000  0.50 10.00           O  \n"
    "ATOM      4  CB ATHR A  11       4.000   0.000   0.000  0.70 10.00           C  \n"
    "ATOM      5  OG BSER A  11       5.000   0.000   0.000  0.30 10.00           O  \n";
  const Macromolecule molecule = ParseMolecule(residue, MoleculeFormat::PDB);
  // B is the most occupied of residue 10 by the sum over its atoms.
  EXPECT_EQ(JoinNames(molecule), "CBB OGB CBA ");
}

TEST(MacromoleculeReader, AssembliesThatTheFileDescribes)
{
  // Two glycines of one chain; the assembly adds a copy 20 angstrom off.
  const std::string remarks =
    "REMARK 350 BIOMOLECULE: 1\n"
    "REMARK 350 AUTHOR DETERMINED BIOLOGICAL UNIT: DIMERIC\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000       20.00000\n"
    "REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n";
  const std::string atoms =
    "ATOM      1  N   GLY A   1       1.000   2.000   3.000  1.00 10.00           N\n"
    "ATOM      2  CA  GLY A   1       2.400   2.000   3.000  1.00 10.00           C\n"
    "CONECT    1    2\nEND\n";
  MoleculeOptions options;
  EXPECT_EQ(ParseMolecule(remarks + atoms, MoleculeFormat::PDB, options).Atoms.size(), 2u);
  options.Assembly = "1";
  const Macromolecule dimer = ParseMolecule(remarks + atoms, MoleculeFormat::PDB, options);
  ASSERT_EQ(dimer.Atoms.size(), 4u);
  EXPECT_NEAR(dimer.Atoms[2].Position[0], 19.0, 1e-6);
  EXPECT_NEAR(dimer.Atoms[2].Position[1], -2.0, 1e-6);
  EXPECT_EQ(dimer.Atoms[0].Chain, "A");
  EXPECT_NE(dimer.Atoms[2].Chain, "A");
  EXPECT_EQ(dimer.Bonds.size(), 2u); // one in each copy
  // gemmi's search for atoms on symmetry axes has memory for copies that are near enough.
  std::string far = remarks;
  far.replace(far.rfind("0.00000\n"), 7, "9999999.9");
  far.replace(far.find("20.00000"), 8, "9999999.9");
  far.replace(far.rfind("0.000000        0.00000\n") + 8, 15, "        9999999");
  EXPECT_NE(CatchMessage(far + atoms, MoleculeFormat::PDB, options).find("too large to search"),
    std::string::npos);
  options.Assembly = "7";
  EXPECT_EQ(CatchMessage(remarks + atoms, MoleculeFormat::PDB, options),
    "test: there is no assembly 7; the file describes 1.");
  EXPECT_EQ(CatchMessage(atoms, MoleculeFormat::PDB, options),
    "test: there is no assembly 7; the file describes none.");
  EXPECT_NE(CatchMessage("1\n\nC 0 0 0\n", MoleculeFormat::XYZ, options).find("assemblies"),
    std::string::npos);
}

TEST(MacromoleculeReader, OutputOfTheVTKClass)
{
  const TemporaryFile files[] = { TemporaryFile(SmallPDB, "small.pdb"),
    TemporaryFile(Gzip(SmallPDB), "small.ent.gz"), TemporaryFile(SmallPDB, "small.PDB") };
  for (const TemporaryFile& file : files)
  {
    const char* name = file.Path();
    Reading reading;
    vtkPolyData* atoms = reading.Read(name);
    ASSERT_EQ(atoms->GetNumberOfPoints(), 5) << name;
    EXPECT_EQ(atoms->GetNumberOfVerts(), 5);
    EXPECT_EQ(atoms->GetNumberOfLines(), 3);
    EXPECT_EQ(atoms->GetPointData()->GetArray("Element")->GetTuple1(3), 26.0);
    EXPECT_EQ(atoms->GetPointData()->GetArray("ResidueId")->GetTuple1(3), 142.0);
    EXPECT_EQ(atoms->GetPointData()->GetAbstractArray("ResidueName")->GetVariantValue(3), "HEM");
    EXPECT_EQ(atoms->GetPointData()->GetAbstractArray("InsertionCode")->GetVariantValue(0), "A");
    EXPECT_FALSE(atoms->GetPointData()->HasArray("AltLoc"));
    EXPECT_EQ(atoms->GetCellData()->GetArray("BondSource")->GetTuple1(7), 1.0);
    EXPECT_EQ(atoms->GetFieldData()->GetAbstractArray("ElementSymbols")->GetVariantValue(26), "Fe");
    EXPECT_EQ(atoms->GetFieldData()->GetArray("NumberOfModels")->GetTuple1(0), 2.0);
    EXPECT_NE(reading.Observer->GetWarningMessage().find("no radius"), std::string::npos);
    vtkMolecule* molecule = reading.Reader->GetMolecule();
    ASSERT_EQ(molecule->GetNumberOfAtoms(), 5);
    EXPECT_EQ(molecule->GetNumberOfBonds(), 3);
    EXPECT_EQ(molecule->GetAtomAtomicNumber(3), 26);
    EXPECT_EQ(molecule->GetBondOrder(0), 1);
    EXPECT_EQ(vtkMacromoleculeReader::CanReadFile(name), 1);
  }
}

TEST(MacromoleculeReader, ErrorsOfTheVTKClass)
{
  const TemporaryFile empty("", "empty.pqr");
  const TemporaryFile letter("Dear Sir or Madam,\n", "letter.cif");
  const std::string whole = Gzip(SmallPDB);
  const TemporaryFile cut(whole.substr(0, whole.size() - 12), "cut.pdb.gz");
  const TemporaryFile noChecksum(whole.substr(0, whole.size() - 5), "cut.pdb.gz");
  const struct
  {
    std::string Path;
    const char* Words;
    unsigned long Code;
  } cases[] = { { "", "set FileName", vtkErrorCode::NoFileNameError },
    { "/nowhere/at/all.pdb", "there is no such file", vtkErrorCode::FileNotFoundError },
    { ::testing::TempDir(), "this is a folder", vtkErrorCode::CannotOpenFileError },
    { empty.Path(), "empty", vtkErrorCode::PrematureEndOfFileError },
    { letter.Path(), "mmCIF", vtkErrorCode::FileFormatError },
    { cut.Path(), "end prematurely", vtkErrorCode::PrematureEndOfFileError },
    { noChecksum.Path(), "end prematurely", vtkErrorCode::PrematureEndOfFileError } };
  for (const auto& c : cases)
  {
    Reading reading;
    vtkPolyData* atoms = reading.Read(c.Path);
    EXPECT_NE(reading.Observer->GetErrorMessage().find(c.Words), std::string::npos)
      << reading.Observer->GetErrorMessage();
    EXPECT_EQ(atoms->GetNumberOfPoints(), 0);
    EXPECT_EQ(reading.Reader->GetMolecule()->GetNumberOfAtoms(), 0);
    EXPECT_EQ(reading.Reader->GetErrorCode(), c.Code) << c.Path;
  }
  const TemporaryFile document(SmallPDB, "a.doc");
  const TemporaryFile binary(std::string("\0\1\2", 3), "binary.pdb");
  EXPECT_EQ(vtkMacromoleculeReader::CanReadFile(nullptr), 0);
  EXPECT_EQ(vtkMacromoleculeReader::CanReadFile("/nowhere/at/all.pdb"), 0);
  EXPECT_EQ(vtkMacromoleculeReader::CanReadFile(document.Path()), 0);
  EXPECT_EQ(vtkMacromoleculeReader::CanReadFile(binary.Path()), 0);
}

TEST(MacromoleculeReader, ReportsProgressAndStops)
{
  std::string text;
  for (int i = 0; i < 100000; ++i)
  {
    text += "ATOM " + std::to_string(i) + " CA SER 1 " + std::to_string(4 * i) + " 0 0 0.1 1.8\n";
  }
  std::vector<double> told;
  MoleculeOptions options;
  options.Format = MoleculeFormat::PQR;
  ParseMacromolecule(text, "test", options,
    [&](double fraction)
    {
      told.push_back(fraction);
      return true;
    });
  EXPECT_GT(told.size(), 5u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_LE(told.back(), 1.0);

  const TemporaryFile file(text, "long.pqr");
  Reading reading;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, stop);
  EXPECT_EQ(reading.Read(file.Path())->GetNumberOfPoints(), 0);
  EXPECT_FALSE(reading.Observer->GetError());
}

// Rows a, b, c. Crystals of small molecules have one as well, but are not made whole by it.
TEST(MacromoleculeReader, PeriodicCell)
{
  const std::string atoms =
    "ATOM      1  CA  SER A  10       0.000   0.000   0.000  1.00 10.00           C  \n";
  const std::string cif = "data_x\n_cell_length_a 10\n_cell_length_b 12\n_cell_length_c 14\n"
                          "_cell_angle_beta 60\n_symmetry_space_group_name_H-M 'P 21/c'\nloop_\n"
                          "_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n"
                          "_atom_site_fract_z\nC1 0.01 0.5 0.5\nC2 0.91 0.5 0.5\n";
  struct Case
  {
    std::string Name, Text;
    std::array<double, 3> C;
    std::string Group;
  };
  const double x = 7.0, z = 7.0 * std::sqrt(3.0);
  for (const Case& known :
    { Case{ "cell.pdb",
        "CRYST1   10.000   12.000   14.000  90.00  60.00  90.00 P 1 21 1      2\n" + atoms,
        { x, 0.0, z }, "P 1 21 1" },
      Case{ "plain.pdb", "CRYST1   10.000   12.000   14.000  90.00  60.00  90.00\n" + atoms,
        { x, 0.0, z }, "" },
      Case{ "cell.cif", cif, { x, 0.0, z }, "P 21/c" } })
  {
    const TemporaryFile file(known.Text, known.Name);
    Reading reading;
    vtkPolyData* output = reading.Read(file.Path());
    vtkDataArray* cell = output->GetFieldData()->GetArray("CellVectors");
    ASSERT_TRUE(cell) << known.Name;
    ASSERT_EQ(cell->GetNumberOfTuples(), 3);
    EXPECT_DOUBLE_EQ(cell->GetComponent(0, 0), 10.0);
    EXPECT_DOUBLE_EQ(cell->GetComponent(1, 1), 12.0);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(cell->GetComponent(2, k), known.C.at(static_cast<std::size_t>(k)), 1e-9);
    }
    vtkAbstractArray* group = output->GetFieldData()->GetAbstractArray("SpaceGroup");
    ASSERT_EQ(group != nullptr, !known.Group.empty()) << known.Name;
    if (group)
    {
      EXPECT_EQ(group->GetVariantValue(0).ToString(), known.Group);
    }
    if (known.Name == "cell.cif") // one and a half angstrom apart across the face
    {
      double p[2][3];
      output->GetPoint(0, p[0]);
      output->GetPoint(1, p[1]);
      EXPECT_NEAR(p[1][0] - p[0][0], 9.0, 1e-9);
    }
  }
  Reading without;
  const TemporaryFile file(atoms, "none.pdb");
  EXPECT_EQ(without.Read(file.Path())->GetFieldData()->GetArray("CellVectors"), nullptr);
}
