// Files of docking and simulation programs, written by hand from their specifications: extended
// XYZ, TINKER, PDBQT, GRO, MOL2, SDF; and formats that are not read, which the message names.

#include "Atoms/ChemicalElement.h"
#include "Files/OpenByteSource.h"
#include "MoleculeTexts.h"
#include "SharedData.h"
#include "TemporaryFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

std::string Symbols(const Macromolecule& molecule)
{
  std::string symbols;
  for (const Atom& atom : molecule.Atoms)
  {
    symbols += std::string(ElementSymbol(atom.Element)) + " ";
  }
  return symbols;
}

Macromolecule Model(const std::string& text, MoleculeFormat format, std::int64_t model)
{
  MoleculeOptions options;
  options.ModelIndex = model;
  options.BondsByDistance = false;
  return ParseMolecule(text, format, options);
}

std::string WhyOfFile(const std::string& content, const std::string& name)
{
  const TemporaryFile file(content, name);
  try
  {
    ReadMacromolecule(file.Path(), {});
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}

#define EXPECT_PART(sentence, part)                                                                \
  EXPECT_NE(std::string(sentence).find(part), std::string::npos) << (sentence)

}

TEST(ExchangeFormats, ExtendedXYZInAnyOrder)
{
  const char* const same[] = {
    "2\nLattice=\"9 0 0 0 9 0 0 0 9\" Properties=species:S:1:pos:R:3 pbc=\"T T T\"\n"
    "O 1 2 3\nNa 4 5 6\n",
    "2\nProperties=forces:R:3:pos:R:3:species:S:1:id:I:1\n.1 .2 .3 1 2 3 O 7\n.1 .2 .3 4 5 6 Na "
    "8\n",
    "2\nProperties=\"id:I:1:Z:I:1:pos:R:3\"\n1 8 1 2 3\n2 11 4 5 6\n",
    "2\ntime=3 Properties=fixed:L:1:species:S:1:q:R:1:radius:R:1:pos:R:3\n"
    "T O -0.5 1.4 1 2 3\nF Na 0.5 1.1 4 5 6\n",
  };
  for (const char* text : same)
  {
    const Macromolecule molecule = Model(text, MoleculeFormat::XYZ, 0);
    EXPECT_EQ(Symbols(molecule), "O Na ") << text;
    EXPECT_EQ(molecule.Atoms[1].Position, (std::array<double, 3>{ 4, 5, 6 })) << text;
  }
  const Macromolecule charged = Model(same[3], MoleculeFormat::XYZ, 0);
  EXPECT_EQ(charged.Atoms[0].Charge, -0.5);
  EXPECT_EQ(charged.Atoms[0].Radius, 1.4);
  ASSERT_FALSE(charged.Notes.empty());
  EXPECT_PART(charged.Notes[0], "not read: fixed.");
  const auto why = [](const std::string& properties)
  { return CatchMessage("1\nProperties=" + properties + "\nO 1 2 3\n", MoleculeFormat::XYZ); };
  EXPECT_PART(why("species:S:1"), "needs the properties species");
  EXPECT_PART(why("pos:R:3"), "needs the properties species");
  EXPECT_PART(why("species:S:1:pos:R"), "name:type:count");
  EXPECT_PART(why("species:S:1:forces:R:3:pos:R:3"), "line 3");
}

TEST(ExchangeFormats, TinkerXYZ)
{
  const std::string water = "     3  Water\n     1  O      0.00    0.10    0.20     1     2     3\n"
                            "     2  H      0.96    0.10    0.20     2     1\n"
                            "     3  H     -0.24    1.03    0.20     2     1\n";
  const std::string box =
    "     3  Water\n    18.6 18.6 18.6 90.0 90.0 90.0\n" + water.substr(water.find('\n') + 1);
  const std::string untitled = "3\n" + water.substr(water.find('\n') + 1);
  for (const std::string& text : { water, box, untitled })
  {
    const Macromolecule molecule = Model(text, MoleculeFormat::XYZ, 0);
    EXPECT_EQ(Symbols(molecule), "O H H ") << text;
    EXPECT_EQ(molecule.Bonds.size(), 2u);
    EXPECT_TRUE(molecule.Bonds[0].FromFile);
    EXPECT_EQ(molecule.Atoms[2].Position[1], 1.03);
  }
  EXPECT_EQ(Model(water + box, MoleculeFormat::XYZ, 1).Atoms.size(), 3u);
  EXPECT_EQ(Model(water + box, MoleculeFormat::XYZ, 1).NumberOfModels, 2);
  const Macromolecule ions =
    Model("4\n1 Na+ 0 0 0 7\n2 CA 9 0 0 1\n3 Cl- 0 9 0 8\n4 HN 0 0 9 2\n", MoleculeFormat::XYZ, 0);
  EXPECT_EQ(Symbols(ions), "Na C Cl H ");
  EXPECT_PART(
    CatchMessage("2\n1 O 0 0 0 1 2\n2 H 1 0 0 1 9\n", MoleculeFormat::XYZ), "atom 9 is bonded");
  EXPECT_PART(CatchMessage("2\n1 O 0 0 0 1 2\n", MoleculeFormat::XYZ), "ends after 1 of 2");
  // A comment of plain XYZ may have numbers.
  EXPECT_EQ(Symbols(Model("1\n1 2 3 4\nC 0 0 0\n", MoleculeFormat::XYZ, 0)), "C ");
}

TEST(ExchangeFormats, PDBQTHasChargesAndAutoDocksTypes)
{
  const auto line = [](const char* name, const char* residue, const char* charge, const char* type)
  {
    char text[100];
    std::snprintf(text, sizeof(text),
      "ATOM      1 %-4s %3s A   2      14.607 -11.551  25.793  1.00 30.50    %6s %-2s\n", name,
      residue, charge, type);
    return std::string(text);
  };
  const std::string ligand = "REMARK VINA RESULT\nROOT\n" + line(" C1", "LIG", "0.127", "A") +
    line(" N1", "LIG", "-0.346", "NA") + "ENDROOT\nBRANCH 1 3\n" +
    line(" O1", "LIG", "-0.271", "OA") + line(" H1", "LIG", "0.163", "HD") +
    line(" S1", "LIG", "0.0", "SA") + line("CL1", "LIG", "0.0", "Cl") +
    line(" G1", "LIG", "0.0", "G0") + "ENDBRANCH 1 3\nTORSDOF 1\n";
  const Macromolecule molecule = Model(ligand, MoleculeFormat::PDBQT, 0);
  EXPECT_EQ(Symbols(molecule), "C N O H S Cl X ");
  EXPECT_EQ(molecule.Atoms[1].Charge, -0.346);
  EXPECT_EQ(molecule.Atoms[0].BFactor, 30.5);
  EXPECT_EQ(Describe(molecule.Atoms[0]), "C1 of LIG 2 A");
  const std::string poses =
    "MODEL 1\n" + ligand + "ENDMDL\nMODEL 2\n" + line(" N1", "LIG", "0.1", "N") + "ENDMDL\n";
  EXPECT_EQ(Model(poses, MoleculeFormat::PDBQT, 1).Atoms.size(), 1u);
  EXPECT_EQ(Model(poses, MoleculeFormat::PDBQT, 1).NumberOfModels, 2);
  EXPECT_EQ(Symbols(Model(line("NA", " NA", "1.0", "Na"), MoleculeFormat::PDBQT, 0)), "Na ");
  const std::string long10 =
    "ATOM      1  N1  LIG A   2      14.607 -11.551  25.793  1.00 30.50-12.345678 N \n";
  EXPECT_EQ(Model(long10, MoleculeFormat::PDBQT, 0).Atoms.at(0).Charge, -12.345678);
  EXPECT_PART(CatchMessage("ATOM      1  C   LIG A   2      14.607 -11.551  25.793  1.00  0.00\n",
                MoleculeFormat::PDBQT),
    "partial charge");
}

TEST(ExchangeFormats, ReportedPDBQTIsRead)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/pdbqt_inputpdbqt.pdbqt");
  const auto path = SharedDataFolder() / "reports/pdbqt_inputpdbqt.pdbqt";
  const Macromolecule molecule = ReadMacromolecule(path.string(), {});
  EXPECT_EQ(molecule.Atoms.size(), 1805u); // lines that begin with ATOM or HETATM
  std::map<std::string, int> elements;
  for (const Atom& atom : molecule.Atoms)
  {
    ++elements[ElementSymbol(atom.Element)];
    // Names of this file begin with the symbol, after digits.
    const auto letter = atom.Name.find_first_not_of("0123456789");
    EXPECT_EQ(std::string(1, atom.Name[letter]), ElementSymbol(atom.Element)) << Describe(atom);
    EXPECT_FALSE(std::isnan(atom.Charge)) << Describe(atom);
  }
  // Types A and C, HD, N, OA, counted with the tools cut and uniq.
  EXPECT_EQ(elements,
    (std::map<std::string, int>{ { "C", 146 + 815 }, { "H", 309 }, { "N", 264 }, { "O", 271 } }));
}

TEST(ExchangeFormats, GROInAngstrom)
{
  const std::string frame =
    "Water t= 0.0\n    3\n    1SOL     OW    1   0.126   1.624   1.679\n"
    "    1SOL    HW1    2   0.190   1.661   1.747\n    2NA      NA    3   "
    "1.275   0.053  -0.622  0.2519  0.3140 -0.1734\n   1.82   1.82   1.82\n";
  const Macromolecule molecule = Model(frame, MoleculeFormat::GRO, 0);
  EXPECT_EQ(Symbols(molecule), "O H Na ");
  EXPECT_EQ(molecule.Atoms[2].Position, (std::array<double, 3>{ 12.75, 0.53, -6.22 }));
  EXPECT_EQ(molecule.Atoms[2].ResidueId, 2);
  EXPECT_EQ(molecule.Atoms[0].ResidueName, "SOL");
  EXPECT_EQ(Model(frame + frame + "\n", MoleculeFormat::GRO, 1).NumberOfModels, 2);
  // More decimals make wider columns.
  const Macromolecule fine = Model(
    "\n1\n    1SOL     OW    1   0.12612   1.62478  -1.67933\n1 1 1\n", MoleculeFormat::GRO, 0);
  EXPECT_EQ(fine.Atoms[0].Position, (std::array<double, 3>{ 1.2612, 16.2478, -16.7933 }));
  EXPECT_PART(
    CatchMessage("t\n2\n    1SOL     OW    1   0.126   1.624   1.679\n", MoleculeFormat::GRO),
    "within a molecule");
  EXPECT_PART(CatchMessage("t\nmany\n", MoleculeFormat::GRO), "line 2");
  // Large boxes run together, with two decimals more than coordinates.
  const std::string atom = "t\n1\n    1SOL     OW    1   0.126   1.624   1.679\n";
  const auto box = [&atom](const char* line)
  {
    const auto cell = Model(atom + line, MoleculeFormat::GRO, 0).Cell;
    return std::array<double, 3>{ cell[0][0], cell[1][1], cell[2][2] };
  };
  const std::array<double, 3> large = box("40000.1234540000.2345640000.34567\n");
  EXPECT_NEAR(large[0], 400001.2345, 1e-6);
  EXPECT_NEAR(large[1], 400002.3456, 1e-6);
  EXPECT_NEAR(large[2], 400003.4567, 1e-6);
  EXPECT_NEAR(box("   1.00000   2.0000040000.34567\n")[2], 400003.4567, 1e-6);
  EXPECT_PART(
    CatchMessage("t\n1\n    1SOL     OW    1   0.1261e300   1.678\n1 1 1\n", MoleculeFormat::GRO),
    "larger than");
}

TEST(ExchangeFormats, MOL2)
{
  const std::string text =
    "# comment\n@<TRIPOS>MOLECULE\nethanol\n 4 3 1 0 0\nSMALL\nGASTEIGER\n\n@<TRIPOS>ATOM\n"
    "  1 C1   0.0 0.0 0.0 C.3  1 ALA12 0.04\n  2 C2   1.5 0.0 0.0 C.ar 1 ALA12 0.1\n"
    "  3 O1   2.0 1.4 0.0 O.co2 1 ALA12 -0.4\n  4 CL   9.0 1.4 0.0 Cl 1 ALA12 0.0\n"
    "@<TRIPOS>BOND\n 1 1 2 1\n 2 2 3 ar\n 3 3 4 1\n@<TRIPOS>SUBSTRUCTURE\n 1 ALA12 1\n";
  const Macromolecule molecule = Model(text, MoleculeFormat::MOL2, 0);
  EXPECT_EQ(Symbols(molecule), "C C O Cl ");
  EXPECT_EQ(molecule.Bonds.size(), 3u);
  EXPECT_EQ(molecule.Atoms[2].Charge, -0.4);
  EXPECT_EQ(Describe(molecule.Atoms[0]), "C1 of ALA 12");
  const std::string second =
    "@<TRIPOS>MOLECULE\nion\n1\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n1 ZN 1 2 3 Zn\n";
  const Macromolecule ion = Model(text + second, MoleculeFormat::MOL2, 1);
  EXPECT_EQ(Symbols(ion), "Zn ");
  EXPECT_EQ(ion.NumberOfModels, 2);
  EXPECT_TRUE(std::isnan(ion.Atoms[0].Charge));
  EXPECT_EQ(Symbols(ParseMolecule(second, MoleculeFormat::ByName)), "Zn ");
  EXPECT_PART(
    CatchMessage(text.substr(0, text.find("  3 O1")), MoleculeFormat::MOL2), "within a molecule");
  const Macromolecule odd = Model("@<TRIPOS>MOLECULE\nx\n1 1\nS\nC\n@<TRIPOS>ATOM\n1 C 0 0 0 C.3\n"
                                  "@<TRIPOS>BOND\n1 1 7 1\n",
    MoleculeFormat::MOL2, 0);
  EXPECT_EQ(odd.Atoms.size() + odd.Bonds.size(), 1u);
  ASSERT_EQ(odd.Warnings.size(), 1u);
  EXPECT_PART(odd.Warnings[0], "Bonds with missing atoms, dropped: 1 (first: line 9)");
}

TEST(ExchangeFormats, NamesOfResiduesInMOL2)
{
  const auto residues = [](const std::vector<std::string>& names)
  {
    std::string text = "@<TRIPOS>MOLECULE\nx\n" + std::to_string(names.size()) +
      "\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n";
    int number = 0;
    for (const std::string& name : names)
    {
      ++number;
      const std::string digits = std::to_string(number);
      text += digits + " C " + digits + " 0 0 C.3 " + digits + " " + name + "\n";
    }
    std::string found;
    for (const Atom& atom : Model(text, MoleculeFormat::MOL2, 0).Atoms)
    {
      found += atom.ResidueName + " " + std::to_string(atom.ResidueId) + ", ";
    }
    return found;
  };
  EXPECT_EQ(residues({ "ALA12", "CYS13", "HOH201" }), "ALA 12, CYS 13, HOH 201, ");
  EXPECT_EQ(residues({ "DC1", "DG2", "DA3" }), "DC 1, DG 2, DA 3, ");
  EXPECT_EQ(residues({ "DC5", "DG", "DA3" }), "DC5 1, DG 2, DA3 3, ");
  EXPECT_EQ(residues({ "SO4" }), "SO4 1, ");
  EXPECT_EQ(residues({ "TIP3", "TIP3" }), "TIP3 1, TIP3 2, ");
  EXPECT_EQ(residues({ "LIG1" }), "LIG 1, ");
  EXPECT_EQ(residues({ "CYS2" }), "CYS 2, ");
  EXPECT_EQ(residues({ "123", "LIG" }), "123 1, LIG 2, ");
}

TEST(ExchangeFormats, SDFOfBothVersions)
{
  const std::string v2000 =
    "formate\n  prog\n\n  3  2  0  0  0  0            999 V2000\n"
    "    0.0000    0.0000    0.0000 C   0  0  0  0  0  0  0  0  0  0  0  0\n"
    "    1.2000    0.0000    0.0000 O   0  0\n   -0.6000    1.1000    0.5000 O   0  0\n"
    "  1  2  2  0  0  0  0\n  1  3  1  0  0  0  0\nM  CHG  1   3  -1\nM  END\n"
    ">  <ID>\n42\n\n$$$$\n";
  const Macromolecule molecule = Model(v2000, MoleculeFormat::SDF, 0);
  EXPECT_EQ(Symbols(molecule), "C O O ");
  EXPECT_EQ(molecule.Bonds.size(), 2u);
  EXPECT_EQ(molecule.Atoms[2].Charge, -1.0);
  EXPECT_EQ(molecule.Atoms[2].Position, (std::array<double, 3>{ -0.6, 1.1, 0.5 }));
  const std::string v3000 =
    "ion\n  prog              2D\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\n"
    "M  V30 COUNTS 2 1 0 0 0\nM  V30 BEGIN ATOM\nM  V30 10 Fe 1.0 2.0 3.0 0 CHG=-\nM  V30 2\n"
    "M  V30 20 Cl 4.0 2.0 3.0 0\nM  V30 END ATOM\nM  V30 BEGIN BOND\nM  V30 1 1 10 20\n"
    "M  V30 END BOND\nM  V30 END CTAB\nM  END\n$$$$\n";
  const Macromolecule second = Model(v2000 + v3000 + "\n", MoleculeFormat::SDF, 1);
  EXPECT_EQ(second.NumberOfModels, 2);
  EXPECT_EQ(Symbols(second), "Fe Cl ");
  EXPECT_EQ(second.Bonds.size(), 1u);
  EXPECT_EQ(second.Atoms[0].Charge, 2.0);
  ASSERT_FALSE(second.Warnings.empty());
  EXPECT_PART(second.Warnings[0], "2D");
  EXPECT_PART(CatchMessage(v2000.substr(0, 150), MoleculeFormat::SDF), "line");
  const Macromolecule odd =
    Model("a\nb\n\n  1  1\n    0.0000    0.0000    0.0000 C\n  1  9  1\nM  END\n",
      MoleculeFormat::SDF, 0);
  EXPECT_EQ(odd.Atoms.size() + odd.Bonds.size(), 1u);
  ASSERT_EQ(odd.Warnings.size(), 1u);
  EXPECT_PART(odd.Warnings[0], "missing atoms, dropped: 1 (first: line 6)");
}

TEST(ExchangeFormats, SDFWithoutItsEndIsReadWithAWarning)
{
  // As aspirin_charged.sdf of chemfiles' test data, whose charges are codes.
  const std::string whole = "a\nb\n\n  1  0\n    0.0000    0.0000    0.0000 Na  0  3\n";
  const Macromolecule ion = Model(whole, MoleculeFormat::SDF, 0);
  ASSERT_EQ(ion.Atoms.size(), 1u);
  EXPECT_EQ(ion.Atoms[0].Charge, 1.0);
  ASSERT_EQ(ion.Warnings.size(), 1u);
  EXPECT_PART(ion.Warnings[0], "ends without M  END");
  EXPECT_TRUE(Model(whole + "M  END\n", MoleculeFormat::SDF, 0).Warnings.empty());
  EXPECT_TRUE(Model(whole + "$$$$\n", MoleculeFormat::SDF, 0).Warnings.empty());
  EXPECT_PART(
    CatchMessage(whole.substr(0, whole.size() - 1), MoleculeFormat::SDF), "ends within this line");
}

// Bytes changed, removed and duplicated at random: atoms or a message, and nothing that is not
// finite.
TEST(ExchangeFormats, DamagedTextsGiveAtomsOrAMessage)
{
  const std::pair<MoleculeFormat, std::string> texts[] = {
    { MoleculeFormat::XYZ, "2\nProperties=pos:R:3:species:S:1:q:R:1\n0 0 0 C 1\n1 2 3 O 2\n" },
    { MoleculeFormat::XYZ, "3 t\n1 O 0 0 0 1 2 3\n2 H 1 0 0 2 1\n3 H 0 1 0 2 1\n" },
    { MoleculeFormat::PDBQT,
      "MODEL 1\nATOM      1  C   LIG A   2      14.607 -11.551  25.793  1.00  0.00     0.127 C \n"
      "ENDMDL\n" },
    { MoleculeFormat::GRO,
      "t\n2\n    1SOL     OW    1   0.126   1.624   1.679\n    1SOL    HW1    2   0.190   1.661   "
      "1.747\n 1 1 1\n" },
    { MoleculeFormat::MOL2,
      "@<TRIPOS>MOLECULE\nx\n2 1\nS\nC\n@<TRIPOS>ATOM\n1 C 0 0 0 C.3 1 ALA1 0\n"
      "2 C 1 0 0 C.3\n@<TRIPOS>BOND\n1 1 2 1\n" },
    { MoleculeFormat::SDF,
      "a\nb\n\n  2  1\n    0.0000    0.0000    0.0000 C\n    1.0000    0.0000    "
      "0.0000 C\n  1  2  1\nM  CHG  1   2  -1\nM  END\n$$$$\n" },
    { MoleculeFormat::SDF,
      "a\nb\n\n 0 0 V3000\nM  V30 BEGIN ATOM\nM  V30 1 C 0 0 0 0 CHG=1\nM  V30 2 C 1 0 0 0\nM  V30 "
      "END "
      "ATOM\nM  V30 BEGIN BOND\nM  V30 1 1 1 2\nM  V30 END BOND\nM  V30 END CTAB\n$$$$\n" },
    { MoleculeFormat::MMCIF,
      "data_x\n_cell_length_a 5\n_cell_length_b 6\n_cell_length_c 7\nloop_\n"
      "_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n"
      "_atom_site_fract_z\n_atom_site_disorder_group\nO1 0 .1 .2 1\nC1 .5 .5 .5 .\n" },
  };
  std::mt19937 random(2024);
  int read = 0;
  for (const auto& [format, whole] : texts)
  {
    ASSERT_EQ(CatchMessage(whole, format), "") << whole;
    for (int trial = 0; trial < 400; ++trial)
    {
      std::string text = whole;
      for (unsigned int changes = random() % 4; changes-- > 0;)
      {
        const std::size_t at = random() % text.size();
        const char* const bytes = " \n-9.eA\0\xff?";
        switch (random() % 3)
        {
          case 0:
            text[at] = bytes[random() % 11];
            break;
          case 1:
            text.erase(at, 1 + random() % 9);
            text += text.empty() ? "x" : "";
            break;
          default:
            text.insert(at, text.substr(random() % text.size(), 1 + random() % 30));
        }
      }
      MoleculeOptions options;
      options.Format = format;
      try
      {
        const Macromolecule molecule = ParseMacromolecule(text, "test", options);
        ++read;
        for (const Atom& atom : molecule.Atoms)
        {
          EXPECT_TRUE(std::isfinite(atom.Position[0] + atom.Position[1] + atom.Position[2]))
            << text;
        }
      }
      catch (const std::runtime_error& error)
      {
        EXPECT_EQ(std::string(error.what()).substr(0, 4), "test") << error.what();
      }
    }
  }
  EXPECT_GT(read, 500);
}

TEST(ExchangeFormats, OtherFormatsAreNamedWithASuggestion)
{
  EXPECT_PART(WhyOfFile("\x83\xa7 binary", "x.bcif"), "BinaryCIF");
  EXPECT_PART(WhyOfFile("\x83\xa7 binary", "x.mmtf"), "MMTF");
  EXPECT_PART(WhyOfFile("{\"data_1ABC\": {}}", "x.json"), "gemmi convert");
  EXPECT_PART(WhyOfFile("PSF\n", "x.psf"), "topology");
  EXPECT_PART(WhyOfFile("CORD", "x.dcd"), "trajectory");
  EXPECT_PART(WhyOfFile(Gzip("\x83\xa7 binary"), "x.mmtf.gz"), "MMTF");
  EXPECT_PART(WhyOfFile("* A\n   1 EXT\n", "x.crd"), "CHARMM or a trajectory of AMBER");
  EXPECT_PART(WhyOfFile("x\n1\n", "x.rst7"), "ambpdb");
  EXPECT_PART(WhyOfFile("tpx", "x.tpr"), "gmx editconf");
  EXPECT_PART(WhyOfFile("CCO", "x.smi"), "--gen3d");
  EXPECT_PART(WhyOfFile("{ f_m_ct", "x.mae"), "obabel");
  EXPECT_PART(WhyOfFile("\x28\xb5\x2f\xfd rest", "x.cif.zst"), "zstd -d");
  EXPECT_PART(WhyOfFile("\xfd"
                        "7zXZ",
                "x.pdb.xz"),
    "xz");
  EXPECT_PART(WhyOfFile("PK\x03\x04", "x.pdb.zip"), "unzip");
}

TEST(ExchangeFormats, OtherFormatsAreRecognisedByTheirContent)
{
  // BinaryCIF's first map has version, encoder and dataBlocks; MMTF's a version of its own.
  const std::string binaryCIF = "\x83\xa7version\xa5"
                                "0.3.0\xa7"
                                "encoder\xa4"
                                "test\xaa"
                                "dataBlocks";
  const std::string mmtf = std::string("\xde\x00\x1f", 3) +
    "\xabmmtfVersion\xa3"
    "1.0";
  for (const char* name : { "x.cif", "x.pdb", "x.ent", "x.pqr", "x.mol2" })
  {
    EXPECT_PART(WhyOfFile(binaryCIF, name),
      std::string(name) == "x.cif" ? "BinaryCIF: the file is damaged" : "this is BinaryCIF");
    EXPECT_PART(WhyOfFile(Gzip(mmtf), name), "this is MMTF");
    EXPECT_PART(WhyOfFile("\n <!DOCTYPE html><html>404</html>", name), "page of a web site");
    EXPECT_PART(WhyOfFile("<?xml version=\"1.0\"?><PDBx:datablock/>", name), "this is XML");
    EXPECT_PART(WhyOfFile("version https://git-lfs.github.com/spec/v1\noid sha256:0\n", name),
      "git lfs pull");
    EXPECT_PART(WhyOfFile("{\"data_1ABC\": {}}", name), "this is JSON");
    EXPECT_PART(WhyOfFile("\x1f\x9d\x90 rest", name), "compress (.Z)");
  }
  for (const char* first :
    { "HEADER    X", "CRYST1   10.0", "REMARK  99", "ATOM      1  N   GLY A   1" })
  {
    EXPECT_PART(WhyOfFile(std::string(first) + "\n", "x.cif"), "this is PDB, not mmCIF");
  }
}
