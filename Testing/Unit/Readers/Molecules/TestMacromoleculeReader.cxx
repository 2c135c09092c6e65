// Small molecules written in the test, with what must come of them by hand. Real files are read by
// Testing/Python/MacromoleculeReader.py, beside gemmi.

#include "vtkMacromoleculeReader.h"

#include "ChemicalElement.h"
#include "MacromoleculeReader.h"
#include "TemporaryFile.h"

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

#include <cmath>

using namespace isthmus;
using isthmus::testing::Gzip;
using isthmus::testing::TemporaryFile;

namespace
{

Macromolecule Parsed(
  const std::string& text, MoleculeFormat format, MoleculeOptions options = MoleculeOptions())
{
  options.Format = format;
  return ParseMacromolecule(text, "test", options);
}

std::string WhyRefused(
  const std::string& text, MoleculeFormat format, const MoleculeOptions& options = {})
{
  try
  {
    Parsed(text, format, options);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}

std::string NamesOf(const Macromolecule& molecule)
{
  std::string names;
  for (const Atom& atom : molecule.Atoms)
  {
    names += atom.Name + (atom.AltLoc == ' ' ? "" : std::string(1, atom.AltLoc)) + " ";
  }
  return names;
}

// Two conformers of a serine, an iron with formal charge, water, a second model.
const char* const SmallPDB =
  "MODEL        1\n"
  "ATOM      1  CA  SER A  10A      0.000   0.000   0.000  1.00 10.00           C  \n"
  "ATOM      2  CB ASER A  10A      1.500   0.000   0.000  0.40 11.00           C  \n"
  "ATOM      3  CB BSER A  10A      0.000   1.500   0.000  0.60 12.00           C  \n"
  "ATOM      4  OG ASER A  10A      2.000   1.300   0.000  0.40 13.00           O  \n"
  "ATOM      5  OG BSER A  10A      1.300   2.000   0.000  0.60                 O  \n"
  "TER\n"
  "HETATM    6 FE   HEM B 142      10.000   0.000   0.000  1.00 14.00          FE3+\n"
  "HETATM    7  O   HOH C   1      12.000   0.000   0.000  1.00 15.00           O  \n"
  "ENDMDL\n"
  "MODEL        2\n"
  "ATOM      1  CA  SER A  10A      5.000   0.000   0.000  1.00 10.00           C  \n"
  "ENDMDL\n"
  "CONECT    6    7\n"
  "CONECT    7    6\n";

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

TEST(MacromoleculeReader, PQRDialectsSayTheSame)
{
  const char* const same[] = {
    "ATOM     36  HB2 ASP A1003    2004.9053004.355-899.274 -0.0212 1.4870",
    "ATOM     36  HB2 ASP A1003    2004.9053004.355-899.274 -0.0212 1.4870 H",
    "ATOM     36  HB2 ASP A1003    2004.9053004.355-899.274 -0.0212 1.4870\r",
    "ATOM 36 HB2 ASP A 1003 2004.905 3004.355 -899.274 -0.0212 1.4870",
    "ATOM  36\tHB2 ASP A1003 +2004.905 3004.355 -8.99274e2 -2.12E-2 1.487",
    "ATOM 36 HB2 ASP A 1003 2004.905 3004.355 -899.274 -0.0212 1.4870 H",
  };
  for (const char* line : same)
  {
    const Macromolecule molecule = Parsed(line, MoleculeFormat::PQR);
    ASSERT_EQ(molecule.Atoms.size(), 1u) << line;
    const Atom& atom = molecule.Atoms[0];
    EXPECT_EQ(atom.Position, (std::array<double, 3>{ 2004.905, 3004.355, -899.274 })) << line;
    EXPECT_EQ(atom.Charge, -0.0212) << line;
    EXPECT_EQ(atom.Radius, 1.487) << line;
    EXPECT_EQ(Describe(atom), "HB2 of ASP 1003 A") << line;
    EXPECT_EQ(atom.Serial, 36) << line;
    EXPECT_EQ(atom.Element, 1) << line;
    EXPECT_TRUE(std::isnan(atom.BFactor) && std::isnan(atom.Occupancy));
  }
}

TEST(MacromoleculeReader, PQRChainsInsertionCodesAndLongNumbers)
{
  const auto describe = [](const char* line)
  { return Describe(Parsed(line, MoleculeFormat::PQR).Atoms.at(0)); };
  EXPECT_EQ(describe("ATOM 1 CA ASP 1003A 1 2 3 0 1"), "CA of ASP 1003A");
  EXPECT_EQ(describe("ATOM 1 CA ASP B 1003A 1 2 3 0 1"), "CA of ASP 1003A B");
  EXPECT_EQ(describe("ATOM 1 CA ASP B 1003 A 1 2 3 0 1"), "CA of ASP 1003A B");
  EXPECT_EQ(describe("ATOM 1 CA ASP 1003 A 1 2 3 0 1"), "CA of ASP 1003A");
  EXPECT_EQ(describe("ATOM 1 CA ASP -5 1 2 3 0 1"), "CA of ASP -5");
  EXPECT_EQ(describe("ATOM 1 CA ASP 7 -5 1 2 3 0 1"), "CA of ASP -5 7"); // a chain named 7
  EXPECT_EQ(describe("HETATM123456 ZN ZN B1004 1 2 3 2 0"), "ZN of ZN 1004 B");
  EXPECT_EQ(describe("ATOM      1  N   GLNN   12      38.274 -43.881  53.562 -0.350 1.650"),
    "N of GLNN 12");
  const Macromolecule zinc = Parsed("HETATM123456 ZN ZN B1004 1 2 3 2 0", MoleculeFormat::PQR);
  EXPECT_EQ(zinc.Atoms[0].Element, 30);
  EXPECT_TRUE(zinc.Atoms[0].IsHetero);
  ASSERT_EQ(zinc.Notes.size(), 1u);
  EXPECT_NE(
    zinc.Notes[0].find("radius 0 in the file, and a charge: ZN of ZN 1004 B"), std::string::npos);
}

TEST(MacromoleculeReader, ElementsFromNames)
{
  const auto symbol = [](const char* name, const char* residue)
  { return std::string(ElementSymbol(ElementOfAtomName(name, residue))); };
  EXPECT_EQ(symbol("CA", "ALA"), "C");
  EXPECT_EQ(symbol("CA", "CA"), "Ca");
  EXPECT_EQ(symbol("NA", "HEM"), "N");
  EXPECT_EQ(symbol("NA+", "NA"), "Na");
  EXPECT_EQ(symbol("Cl-", "Cl-"), "Cl");
  EXPECT_EQ(symbol("HG", "NCYS"), "H");
  EXPECT_EQ(symbol("1HD2", "LEU"), "H");
  EXPECT_EQ(symbol("SE", "MSE"), "Se");
  EXPECT_EQ(symbol("FE", "HEM"), "Fe");
  EXPECT_EQ(symbol("CL1", "LIG"), "Cl");
  EXPECT_EQ(symbol("", ""), "X");
  EXPECT_EQ(symbol("*", "?"), "X");
  for (int element = 1; element < NumberOfElements; ++element)
  {
    EXPECT_EQ(ElementOfSymbol(ElementSymbol(element)), element);
  }
}

TEST(MacromoleculeReader, RadiiOfTheNamedTables)
{
  // Bondi 1964, table I; Alvarez 2013, table 1.
  EXPECT_EQ(VanDerWaalsRadius(6, RadiusTable::Bondi), 1.70);
  EXPECT_EQ(VanDerWaalsRadius(8, RadiusTable::Bondi), 1.52);
  EXPECT_EQ(VanDerWaalsRadius(16, RadiusTable::Bondi), 1.80);
  EXPECT_EQ(VanDerWaalsRadius(6, RadiusTable::Alvarez), 1.77);
  EXPECT_EQ(VanDerWaalsRadius(26, RadiusTable::Alvarez), 2.44);
  EXPECT_TRUE(std::isnan(VanDerWaalsRadius(26, RadiusTable::Bondi)));
  EXPECT_TRUE(std::isnan(VanDerWaalsRadius(0, RadiusTable::Alvarez)));
  EXPECT_TRUE(std::isnan(VanDerWaalsRadius(-3, RadiusTable::Bondi)));
}

TEST(MacromoleculeReader, PDBValuesAndWhatIsUnknown)
{
  const Macromolecule molecule = Parsed(SmallPDB, MoleculeFormat::PDB);
  EXPECT_EQ(molecule.NumberOfModels, 2);
  EXPECT_EQ(NamesOf(molecule), "CA CBB OGB FE O ");
  EXPECT_EQ(Describe(molecule.Atoms[0]), "CA of SER 10A A");
  EXPECT_EQ(molecule.Atoms[1].Occupancy, 0.6);
  EXPECT_EQ(molecule.Atoms[1].BFactor, 12.0);
  EXPECT_TRUE(std::isnan(molecule.Atoms[2].BFactor)); // blank
  EXPECT_EQ(molecule.Atoms[3].Charge, 3.0);
  EXPECT_TRUE(std::isnan(molecule.Atoms[0].Charge));
  EXPECT_TRUE(std::isnan(molecule.Atoms[3].Radius)); // no iron in Bondi's table
  ASSERT_EQ(molecule.Warnings.size(), 1u);
  EXPECT_NE(molecule.Warnings[0].find("FE of HEM 142 B"), std::string::npos);
  // CA-CB and CB-OG by distance, Fe-O by CONECT, each once.
  ASSERT_EQ(molecule.Bonds.size(), 3u);
  EXPECT_FALSE(molecule.Bonds[0].FromFile);
  EXPECT_TRUE(molecule.Bonds[2].FromFile);
  EXPECT_EQ(molecule.Bonds[2].First, 3);
}

TEST(MacromoleculeReader, Selections)
{
  MoleculeOptions options;
  options.AltLoc = "A";
  EXPECT_EQ(NamesOf(Parsed(SmallPDB, MoleculeFormat::PDB, options)), "CA CBA OGA FE O ");
  options.AltLoc = "*";
  const Macromolecule all = Parsed(SmallPDB, MoleculeFormat::PDB, options);
  EXPECT_EQ(NamesOf(all), "CA CBA CBB OGA OGB FE O ");
  // CA to both CB, each CB to its own OG: never one conformer to the other; Fe-O of the file.
  EXPECT_EQ(all.Bonds.size(), 5u);
  options.AltLoc.clear();
  options.Chains = " B,C";
  EXPECT_EQ(NamesOf(Parsed(SmallPDB, MoleculeFormat::PDB, options)), "FE O ");
  options.Water = false;
  const Macromolecule iron = Parsed(SmallPDB, MoleculeFormat::PDB, options);
  EXPECT_EQ(NamesOf(iron), "FE ");
  EXPECT_TRUE(iron.Bonds.empty()); // its partner is gone
  options.Hetero = false;
  EXPECT_TRUE(Parsed(SmallPDB, MoleculeFormat::PDB, options).Atoms.empty());
  options = MoleculeOptions();
  options.Model = 1;
  EXPECT_EQ(Parsed(SmallPDB, MoleculeFormat::PDB, options).Atoms.at(0).Position[0], 5.0);
  options.Radii = RadiusTable::Alvarez;
  options.Model = 0;
  EXPECT_TRUE(Parsed(SmallPDB, MoleculeFormat::PDB, options).Warnings.empty());

  options = MoleculeOptions();
  options.Chains = "A X";
  EXPECT_EQ(
    WhyRefused(SmallPDB, MoleculeFormat::PDB, options), "There is no chain X; there are: A B C.");
  options = MoleculeOptions();
  options.AltLoc = "Q";
  EXPECT_NE(
    WhyRefused(SmallPDB, MoleculeFormat::PDB, options).find("location Q"), std::string::npos);
  options.AltLoc = "AB";
  EXPECT_NE(
    WhyRefused(SmallPDB, MoleculeFormat::PDB, options).find("one letter"), std::string::npos);
  options = MoleculeOptions();
  options.Model = 2;
  EXPECT_EQ(WhyRefused(SmallPDB, MoleculeFormat::PDB, options),
    "test: there is no model 2, they are numbered 0 to 1.");
}

TEST(MacromoleculeReader, OneConformerOfEachResidueIsWhole)
{
  // Equal occupancies: the first letter. An atom that only the other conformer has is kept, unless
  // the conformers are two different residues (1EN2 has such).
  const char* const residue =
    "ATOM      1  CB ASER A  10       0.000   0.000   0.000  0.50 10.00           C  \n"
    "ATOM      2  CB BSER A  10       1.000   0.000   0.000  0.50 10.00           C  \n"
    "ATOM      3  OG BSER A  10       3.000   0.000   0.000  0.50 10.00           O  \n"
    "ATOM      4  CB ATHR A  11       4.000   0.000   0.000  0.70 10.00           C  \n"
    "ATOM      5  OG BSER A  11       5.000   0.000   0.000  0.30 10.00           O  \n";
  const Macromolecule molecule = Parsed(residue, MoleculeFormat::PDB);
  // B is the most occupied of residue 10 by the sum over its atoms.
  EXPECT_EQ(NamesOf(molecule), "CBB OGB CBA ");
}

TEST(MacromoleculeReader, OldColumnsAreLeftOutWithAWarning)
{
  const std::string old =
    "ATOM      1  C   FOR A   0      -1.409   0.501   0.859  1.00  1.00      1GRM 125\n"
    "ATOM      2  O   FOR A   0      -1.445   1.720   0.692  1.00  1.00      1GRM 126\n";
  const Macromolecule molecule = Parsed(old, MoleculeFormat::PDB);
  ASSERT_EQ(molecule.Atoms.size(), 2u);
  EXPECT_EQ(molecule.Atoms[1].Element, 8);
  EXPECT_TRUE(std::isnan(molecule.Atoms[1].Charge));
  ASSERT_EQ(molecule.Warnings.size(), 1u);
  EXPECT_NE(molecule.Warnings[0].find("Columns 73-80"), std::string::npos);
  // One digit would pass for a charge.
  const Macromolecule five =
    Parsed("ATOM      1  C   FOR A   0      -1.409   0.501   0.859  1.00  1.00      1GRM   5\n",
      MoleculeFormat::PDB);
  EXPECT_TRUE(std::isnan(five.Atoms.at(0).Charge));
}

TEST(MacromoleculeReader, XYZFrames)
{
  const std::string text =
    "3\nwater\nO 0 0 0 7 8\nH 0.96 0 0\n1 -0.24 0.93 0\n2\n\nC 0 0 0\nFe 0 0 2\n";
  const Macromolecule water = Parsed(text, MoleculeFormat::XYZ);
  EXPECT_EQ(NamesOf(water), "O H H ");
  EXPECT_EQ(water.NumberOfModels, 2);
  EXPECT_EQ(water.Bonds.size(), 2u);
  EXPECT_EQ(water.Atoms[2].Position[1], 0.93);
  MoleculeOptions second;
  second.Model = 1;
  EXPECT_EQ(NamesOf(Parsed(text, MoleculeFormat::XYZ, second)), "C Fe ");
  EXPECT_EQ(
    Parsed("1\nProperties=species:S:1:pos:R:3:forces:R:3\nC 0 0 0 1 1 1\n", MoleculeFormat::XYZ)
      .Atoms.size(),
    1u);
  EXPECT_NE(WhyRefused("1\nProperties=pos:R:3:species:S:1\n0 0 0 C\n", MoleculeFormat::XYZ)
              .find("columns are others"),
    std::string::npos);
}

TEST(MacromoleculeReader, BadFilesEndInASentence)
{
  const struct
  {
    MoleculeFormat Format;
    const char* Text;
    const char* Words;
  } cases[] = {
    { MoleculeFormat::PDB, "", "no atom" },
    { MoleculeFormat::PDB, "Dear Sir or Madam,\nthis is text.\n", "no atom" },
    { MoleculeFormat::PDB, "ATOM      1  CA  SER A  10       0.000   0.0", "line 1" },
    { MoleculeFormat::PDB, "ATOM      1  CA  SER A  10       0.000   0.000     nan  1.00 10.00\n",
      "columns 47 to 54" },
    { MoleculeFormat::PDB, "ATOM      1  CA  SER A  10      inf      0.000   0.000  1.00 10.00\n",
      "columns 31 to 38" },
    // One column to the left, and no blanks to go by.
    { MoleculeFormat::PDB,
      "ATOM      1  CA  SER A  10   2004.9053004.355-899.274  1.00 10.00           C\n",
      "columns 39 to 46" },
    { MoleculeFormat::MMCIF, "", "can't be read as mmCIF" },
    { MoleculeFormat::MMCIF, "data_x\nloop_\n_atom_site.id\n_atom_site.type_symbol\n1 C 2\n",
      "can't be read as mmCIF" },
    { MoleculeFormat::MMCIF, "data_x\n_cell.length_a 3\n", "no atom" },
    { MoleculeFormat::PQR, "", "no atom" },
    { MoleculeFormat::PQR, "REMARK nothing\n", "no atom" },
    { MoleculeFormat::PQR, "ATOM 1 CA SER 1 0 0 0 0.1 1.8\nATOM 2 CA SER 1 0 0\n", "line 2" },
    { MoleculeFormat::PQR, "ATOM 1 CA SER 1 0 0 nan 0.1 1.8\n", "not finite" },
    { MoleculeFormat::PQR, "ATOM 1 CA SER 1 0 0 0 nan 1.8\n", "not finite" },
    { MoleculeFormat::PQR, "ATOM 1 CA SER 1 0 0 0 1.8 -0.4\n", "negative" },
    { MoleculeFormat::PQR, "ATOM      1  CA  SER A  10       0.000   0.000   0.000  1.00\n",
      "no atom of a PQR" },
    { MoleculeFormat::XYZ, "C 0 0 0\n", "number of atoms" },
    { MoleculeFormat::XYZ, "2\n\nC 0 0 0\n", "ends after 1 of 2" },
    { MoleculeFormat::XYZ, "1\n\nC 0 zero 0\n", "line 3" },
    { MoleculeFormat::XYZ, "1\n\nC 0 0 inf\n", "line 3" },
    { MoleculeFormat::XYZ, "1\n\n200 0 0 0\n", "no element 200" },
    { MoleculeFormat::ByName, "hello", "Name the format" },
  };
  for (const auto& c : cases)
  {
    EXPECT_NE(WhyRefused(c.Text, c.Format).find(c.Words), std::string::npos)
      << c.Text << "\nsaid: " << WhyRefused(c.Text, c.Format);
  }
  // gemmi takes small letters as well, and would make 0 of what is no number.
  EXPECT_NE(WhyRefused("atom      1  ca  ser a  10       0.000   0.000     nan  1.00 10.00\n",
              MoleculeFormat::PDB)
              .find("columns 47 to 54"),
    std::string::npos);
  // Cut anywhere within the coordinates or later fields, no cut file is taken for another molecule.
  const std::string whole = "ATOM 1 CA SER 1 1.5 2.5 3.5 0.1 1.8\n";
  for (std::size_t size = 1; size + 4 < whole.size(); ++size)
  {
    EXPECT_NE(WhyRefused(whole.substr(0, size), MoleculeFormat::PQR), "") << size;
  }
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
    { cut.Path(), "break off", vtkErrorCode::PrematureEndOfFileError },
    { noChecksum.Path(), "break off", vtkErrorCode::PrematureEndOfFileError } };
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

TEST(MacromoleculeReader, ProgressRisesAndStopIsHonoured)
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
  EXPECT_EQ(Parsed(remarks + atoms, MoleculeFormat::PDB, options).Atoms.size(), 2u);
  options.Assembly = "1";
  const Macromolecule dimer = Parsed(remarks + atoms, MoleculeFormat::PDB, options);
  ASSERT_EQ(dimer.Atoms.size(), 4u);
  EXPECT_NEAR(dimer.Atoms[2].Position[0], 19.0, 1e-6);
  EXPECT_NEAR(dimer.Atoms[2].Position[1], -2.0, 1e-6);
  EXPECT_EQ(dimer.Atoms[0].Chain, "A");
  EXPECT_NE(dimer.Atoms[2].Chain, "A");
  EXPECT_EQ(dimer.Bonds.size(), 2u); // one in each copy
  options.Assembly = "7";
  EXPECT_EQ(WhyRefused(remarks + atoms, MoleculeFormat::PDB, options),
    "test: there is no assembly 7; the file describes 1.");
  EXPECT_EQ(WhyRefused(atoms, MoleculeFormat::PDB, options),
    "test: there is no assembly 7; the file describes none.");
  EXPECT_NE(WhyRefused("1\n\nC 0 0 0\n", MoleculeFormat::XYZ, options).find("assemblies"),
    std::string::npos);
}
