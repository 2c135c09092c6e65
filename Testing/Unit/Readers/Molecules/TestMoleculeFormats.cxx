// Small molecules written in the test in each format, with expected results written by hand.

#include "Atoms/AtomRadii.h"
#include "Atoms/ChemicalElement.h"
#include "Files/TextLines.h"
#include "MoleculeTexts.h"
#include "Molecules/MoleculeParsers.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

TEST(MacromoleculeReader, PQRDialectsAgree)
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
    const Macromolecule molecule = ParseMolecule(line, MoleculeFormat::PQR);
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

TEST(MacromoleculeReader, PQRNumbersThatFillTheirColumns)
{
  const Macromolecule molecule = ParseMolecule(
    "ATOM     36  HB2 ASP A1003    2004.9053004.355-899.274 -0.021212.50000", MoleculeFormat::PQR);
  ASSERT_EQ(molecule.Atoms.size(), 1u);
  EXPECT_EQ(molecule.Atoms[0].Charge, -0.0212);
  EXPECT_EQ(molecule.Atoms[0].Radius, 12.5);
  // To the last column of both, and from the first.
  const Macromolecule full = ParseMolecule(
    "ATOM     36  HB2 ASP A1003    2004.9053004.355-899.274-10.021212.50009", MoleculeFormat::PQR);
  EXPECT_EQ(full.Atoms.at(0).Charge, -10.0212);
  EXPECT_EQ(full.Atoms.at(0).Radius, 12.50009);
  const Macromolecule wide = ParseMolecule(
    "ATOM     36  HB2 ASP A1003    2004.9053004.355-899.274-10.0212112.5000", MoleculeFormat::PQR);
  EXPECT_EQ(wide.Atoms.at(0).Radius, 112.5);
}

TEST(MacromoleculeReader, PQRChainsInsertionCodesAndLongNumbers)
{
  const auto describe = [](const char* line)
  { return Describe(ParseMolecule(line, MoleculeFormat::PQR).Atoms.at(0)); };
  EXPECT_EQ(describe("ATOM 1 CA ASP 1003A 1 2 3 0 1"), "CA of ASP 1003A");
  EXPECT_EQ(describe("ATOM 1 CA ASP B 1003A 1 2 3 0 1"), "CA of ASP 1003A B");
  EXPECT_EQ(describe("ATOM 1 CA ASP B 1003 A 1 2 3 0 1"), "CA of ASP 1003A B");
  EXPECT_EQ(describe("ATOM 1 CA ASP 1003 A 1 2 3 0 1"), "CA of ASP 1003A");
  EXPECT_EQ(describe("ATOM 1 CA ASP -5 1 2 3 0 1"), "CA of ASP -5");
  EXPECT_EQ(describe("ATOM 1 CA ASP 7 -5 1 2 3 0 1"), "CA of ASP -5 7"); // a chain named 7
  EXPECT_EQ(describe("HETATM123456 ZN ZN B1004 1 2 3 2 0"), "ZN of ZN 1004 B");
  EXPECT_EQ(describe("ATOM      1  N   GLNN   12      38.274 -43.881  53.562 -0.350 1.650"),
    "N of GLNN 12");
  const Macromolecule zinc =
    ParseMolecule("HETATM123456 ZN ZN B1004 1 2 3 2 0", MoleculeFormat::PQR);
  EXPECT_EQ(zinc.Atoms[0].Element, 30);
  EXPECT_TRUE(zinc.Atoms[0].IsHetero);
  ASSERT_EQ(zinc.Notes.size(), 1u);
  EXPECT_NE(
    zinc.Notes[0].find("radius 0 in the file, and a charge: ZN of ZN 1004 B"), std::string::npos);
}

TEST(MacromoleculeReader, ElementsFromNames)
{
  const auto symbol = [](const char* name, const char* residue)
  { return std::string(ElementSymbol(ElementFromAtomName(name, residue))); };
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
    EXPECT_EQ(ElementFromSymbol(ElementSymbol(element)), element);
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

TEST(MacromoleculeReader, PDBKnownAndUnknownValues)
{
  const Macromolecule molecule = ParseMolecule(SmallPDB, MoleculeFormat::PDB);
  EXPECT_EQ(molecule.NumberOfModels, 2);
  EXPECT_EQ(JoinNames(molecule), "CA CBB OGB FE O ");
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

// Found by FuzzMacromoleculeReader: gemmi adds up all ten digits of a DBREF2 record, beyond the
// range of an int (undefined, as the sanitizers report).
TEST(MacromoleculeReader, DatabaseReferencesAreNotParsedAsNumbers)
{
  const std::string references =
    "DBREF1 1ABC A    1     2  UNP                  A0A000_HUMAN\n"
    "DBREF2 1ABC A     A0A000                     9999999999  8888888888\n"
    "dbref  1ABC A    1     2  UNP    P12345   X_HUMAN      99999  99999\n";
  const Macromolecule with = ParseMolecule(references + SmallPDB, MoleculeFormat::PDB);
  const Macromolecule without = ParseMolecule(SmallPDB, MoleculeFormat::PDB);
  EXPECT_EQ(JoinNames(with), JoinNames(without));
  EXPECT_EQ(with.Bonds.size(), without.Bonds.size());
  EXPECT_EQ(with.Warnings, without.Warnings);
}

TEST(MacromoleculeReader, OldColumnsAreDroppedWithAWarning)
{
  const std::string old =
    "ATOM      1  C   FOR A   0      -1.409   0.501   0.859  1.00  1.00      1GRM 125\n"
    "ATOM      2  O   FOR A   0      -1.445   1.720   0.692  1.00  1.00      1GRM 126\n";
  const Macromolecule molecule = ParseMolecule(old, MoleculeFormat::PDB);
  ASSERT_EQ(molecule.Atoms.size(), 2u);
  EXPECT_EQ(molecule.Atoms[1].Element, 8);
  EXPECT_TRUE(std::isnan(molecule.Atoms[1].Charge));
  // Half of the atoms are not the majority; a second part is counted separately.
  const std::string charged =
    "ATOM      1 ZN    ZN A   0      -1.409   0.501   0.859  1.00  1.00          ZN2+\n"
    "ATOM      2 ZN    ZN A   1      -1.445   1.720   0.692  1.00  1.00          ZN2+\n";
  EXPECT_EQ(ParseMolecule(charged + old, MoleculeFormat::PDB).Atoms.at(0).Charge, 2.0);
  EXPECT_TRUE(
    std::isnan(ParseMolecule(charged + old + old, MoleculeFormat::PDB).Atoms.at(2).Charge));
  ASSERT_EQ(molecule.Warnings.size(), 1u);
  EXPECT_NE(molecule.Warnings[0].find("Columns 73-80"), std::string::npos);
  // One digit could be taken for a charge.
  const Macromolecule five = ParseMolecule(
    "ATOM      1  C   FOR A   0      -1.409   0.501   0.859  1.00  1.00      1GRM   5\n",
    MoleculeFormat::PDB);
  EXPECT_TRUE(std::isnan(five.Atoms.at(0).Charge));
}

TEST(MacromoleculeReader, XYZFrames)
{
  const std::string text =
    "3\nwater\nO 0 0 0 7 8\nH 0.96 0 0\n1 -0.24 0.93 0\n2\n\nC 0 0 0\nFe 0 0 2\n";
  const Macromolecule water = ParseMolecule(text, MoleculeFormat::XYZ);
  EXPECT_EQ(JoinNames(water), "O H H ");
  EXPECT_EQ(water.NumberOfModels, 2);
  EXPECT_EQ(water.Bonds.size(), 2u);
  EXPECT_EQ(water.Atoms[2].Position[1], 0.93);
  MoleculeOptions second;
  second.ModelIndex = 1;
  EXPECT_EQ(JoinNames(ParseMolecule(text, MoleculeFormat::XYZ, second)), "C Fe ");
  EXPECT_EQ(ParseMolecule(
              "1\nProperties=species:S:1:pos:R:3:forces:R:3\nC 0 0 0 1 1 1\n", MoleculeFormat::XYZ)
              .Atoms.size(),
    1u);
  // Columns in another order were once refused.
  const Macromolecule other =
    ParseMolecule("1\nProperties=pos:R:3:species:S:1\n0 2 0 C\n", MoleculeFormat::XYZ);
  ASSERT_EQ(JoinNames(other), "C ");
  EXPECT_EQ(other.Atoms[0].Position[1], 2.0);
}

TEST(MacromoleculeReader, BadFilesAreReported)
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
    // One column to the left, and no blanks that separate the fields.
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
      "not an atom of a PQR" },
    { MoleculeFormat::XYZ, "C 0 0 0\n", "number of atoms" },
    { MoleculeFormat::XYZ, "2\n\nC 0 0 0\n", "ends after 1 of 2" },
    { MoleculeFormat::XYZ, "1\n\nC 0 zero 0\n", "line 3" },
    { MoleculeFormat::XYZ, "1\n\nC 0 0 inf\n", "line 3" },
    { MoleculeFormat::XYZ, "1\n\n200 0 0 0\n", "no element 200" },
    { MoleculeFormat::ByName, "hello", "Choose the format" },
  };
  for (const auto& c : cases)
  {
    EXPECT_NE(CatchMessage(c.Text, c.Format).find(c.Words), std::string::npos)
      << c.Text << "\nsaid: " << CatchMessage(c.Text, c.Format);
  }
  // gemmi takes small letters as well, and would read 0 from anything that is not a number.
  EXPECT_NE(CatchMessage("atom      1  ca  ser a  10       0.000   0.000     nan  1.00 10.00\n",
              MoleculeFormat::PDB)
              .find("columns 47 to 54"),
    std::string::npos);
  // Cut anywhere within the coordinates or later fields, no cut file is taken for another molecule.
  const std::string whole = "ATOM 1 CA SER 1 1.5 2.5 3.5 0.1 1.8\n";
  for (std::size_t size = 1; size + 4 < whole.size(); ++size)
  {
    EXPECT_NE(CatchMessage(whole.substr(0, size), MoleculeFormat::PQR), "") << size;
  }
}

TEST(MacromoleculeReader, FormatsAreRecognisedByTheirContent)
{
  const std::pair<MoleculeFormat, const char*> texts[] = {
    { MoleculeFormat::PDB, "REMARK\nHETATM    1  O   HOH A   1       1.000   2.000   3.000\n" },
    { MoleculeFormat::MMCIF, "# ATOM\ndata_w\n_cell.length_a 1\n" },
    { MoleculeFormat::XYZ, "2\nwater\nO 1 2 3\nH 1 2 4\n" },
    { MoleculeFormat::XYZ, "1 water\n1 O 1.0 2.0 3.0 5\n" },
    { MoleculeFormat::GRO, "water\n    1\n    1SOL     OW    1   0.100   0.200   0.300\n1 1 1\n" },
    { MoleculeFormat::MOL2, "# from a program\n@<TRIPOS>MOLECULE\nw\n" },
    { MoleculeFormat::SDF, "w\n\n\n  1  0  0  0  0  0  0  0  0  0999 V2000\n" }
  };
  for (const auto& [format, text] : texts)
  {
    EXPECT_EQ(FormatFromText(text, "test"), format) << text;
  }
  EXPECT_THROW(FormatFromText("2 b\nor not\n", "test"), std::runtime_error);
}

TEST(MacromoleculeReader, EndingsOfTheTableChooseTheFormat)
{
  std::string_view endings = MoleculeEndings();
  std::size_t count = 0;
  for (auto ending = NextWord(endings); !ending.empty(); ending = NextWord(endings), ++count)
  {
    const std::string name = "a.b/WATER" + std::string(ending);
    const MoleculeFormat format = FormatFromName(name);
    ASSERT_NE(format, MoleculeFormat::ByName) << name;
    EXPECT_EQ(FormatFromName(name + ".GZ"), format);
    EXPECT_EQ(FormatFromName(name + ".bz2"), format);
    EXPECT_NE(FindFormat(format).Endings.find(ending.substr(1)), std::string_view::npos);
  }
  EXPECT_GE(count, 24u);
  for (const char* other :
    { "water", "water.gz", "pdb", "water.pdb0", "water.pdb.zip", "water.apdb" })
  {
    EXPECT_EQ(FormatFromName(other), MoleculeFormat::ByName) << other;
  }
}
