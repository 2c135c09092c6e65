// What readers of each format report that they decided or dropped: notes, and one warning, with
// counts.

#include "MoleculeTexts.h"
#include "PDBText.h"
#include "TemporaryFile.h"
#include "vtkMacromoleculeReader.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

Macromolecule Read(const std::string& text, MoleculeFormat format)
{
  MoleculeOptions options;
  options.BondsByDistance = false;
  return ParseMolecule(text, format, options);
}

/// Each of `counts` is in the notes and in the one warning of the reader.
void ExpectCounts(const Macromolecule& molecule, const std::vector<std::string>& counts)
{
  ASSERT_FALSE(molecule.Warnings.empty());
  for (const std::string& words : counts)
  {
    EXPECT_NE(molecule.Warnings[0].find(words), std::string::npos) << words << "\n"
                                                                   << molecule.Warnings[0];
    EXPECT_TRUE(Mention(molecule.Notes, words)) << words;
  }
}

std::string Charges(const Macromolecule& molecule)
{
  std::string charges;
  for (const Atom& atom : molecule.Atoms)
  {
    charges += std::isnan(atom.Charge) ? "? " : std::to_string(std::lround(atom.Charge)) + " ";
  }
  return charges;
}

}

TEST(ReadingReport, PDBQT)
{
  const std::string good =
    "ATOM      1  C1  LIG A   2      14.607 -11.551  25.793  1.00 30.50     0.127 C \n";
  const Macromolecule molecule = Read(good +
      "ATOM      2  C2  LIG A   x      15.607 -11.551  25.793  1.00  y.yy     0.1x7 C \n" +
      "ATOM      3  G1  LIG A   2      16.607 -11.551  25.793  z.00 30.50     0.127 G0\n" +
      "ATOM      4  W1  LIG A   2      17.607 -11.551  25.793  1.00 30.50     0.127 W \n" +
      "ATOM      5  DU  LIG A   2      18.607 -11.551  25.793  1.00 30.50     0.127 X \n",
    MoleculeFormat::PDBQT);
  EXPECT_EQ(JoinElements(molecule), "C C X X X ");
  EXPECT_EQ(Charges(molecule), "0 ? 0 0 0 ");
  ExpectCounts(molecule,
    { "Residue numbers that are not integers, taken as 0: 1 (first: line 2).",
      "Occupancies and B factors that are not numbers, dropped: 2 (first: line 2).",
      "Charges that are not numbers, dropped: 1 (first: line 2).",
      "Atoms whose types or symbols match no element (Element is 0): 2 (first: G1 of LIG 2 A).",
      "Ghost or dummy atoms and virtual sites, without element (0) and radius: 1." });
  EXPECT_TRUE(Read(good, MoleculeFormat::PDBQT).Warnings.empty());
  // Errors in other models are not reported for this one.
  EXPECT_TRUE(Read("MODEL 1\n" + good + "ENDMDL\nMODEL 2\n" + good.substr(0, 22) + "   x" +
      good.substr(26) + "ENDMDL\n",
    MoleculeFormat::PDBQT)
                .Warnings.empty());
}

TEST(ReadingReport, GRO)
{
  const auto line = [](const char* residue, const char* name, double x)
  {
    std::array<char, 80> text;
    std::snprintf(
      text.data(), text.size(), "%-10s%5s%5d%8.3f%8.3f%8.3f\n", residue, name, 1, x, 0.0, 0.0);
    return std::string(text.data());
  };
  const Macromolecule molecule =
    Read("t\n7\n" + line("    1LYSH", "CA", 0) + line("    1LYSH", "NZ", 0.1) +
        line("    xSOL", "OW", 1) + line("    2SOL", "MW", 1.1) + line("    3CAL", "CAL", 2) +
        line("    4LIG", "??", 3) + line("    5ALA", "QB", 4) + " 9 9 9\n",
      MoleculeFormat::GRO);
  EXPECT_EQ(JoinElements(molecule), "C N O X Ca X X ");
  ExpectCounts(molecule,
    { "Residue numbers that are not integers, taken as 0: 1 (first: line 5).",
      "Ghost or dummy atoms and virtual sites, without element (0) and radius: 1.",
      "Atoms whose names match no element (Element is 0): 2 (first: ?? of LIG 4)." });
  EXPECT_TRUE(Mention(molecule.Notes, "decided 4 by residue and atom name.")) << molecule.Notes[1];
  // No GRO file has elements: a note, no warning.
  EXPECT_TRUE(
    Read("t\n1\n" + line("    1SOL", "OW", 0) + " 9 9 9\n", MoleculeFormat::GRO).Warnings.empty());
  const Macromolecule beads = Read("t\n3\n" + line("    1ALA", "BB", 0) + line("    2W", "W", 1) +
      line("    3ION", "NA", 2) + " 9 9 9\n",
    MoleculeFormat::GRO);
  EXPECT_EQ(JoinElements(beads), "X X X ");
  ExpectCounts(beads,
    { "Beads of a coarse-grained model (Martini), without element (0) and "
      "radius: 3." });
}

TEST(ReadingReport, MOL2)
{
  const Macromolecule molecule = Read(
    "@<TRIPOS>MOLECULE\nx\n4 4\nSMALL\nUSER_CHARGES\n@<TRIPOS>ATOM\n1 C1 0 0 0 C.3 1 LIG -1.0\n"
    "2 C2 2 0 0 C.3 one LIG ?\n3 DU 4 0 0 Du 1 LIG 0\n4 R1 6 0 0 Any 1 LIG 0\n@<TRIPOS>BOND\n"
    "1 1 2 1\n2 1 9 1\n3 a b 1\n4 2 2 1\n@<TRIPOS>CRYSIN\n1 2 3 90 90 90 1 1\n"
    "@<TRIPOS>SUBSTRUCTURE\n1 LIG 1\n@<TRIPOS>SET\n",
    MoleculeFormat::MOL2);
  EXPECT_EQ(JoinElements(molecule), "C C X X ");
  EXPECT_EQ(Charges(molecule), "-1 ? 0 0 ");
  EXPECT_EQ(molecule.Bonds.size(), 1u);
  ExpectCounts(molecule,
    { "Bonds with missing atoms, dropped: 2 (first: line 13).",
      "Unreadable bonds, dropped: 1 (first: line 14).",
      "Residue numbers that are not integers, taken as 0: 1 (first: line 8).",
      "Charges that are not numbers, dropped: 1 (first: line 8).",
      "Ghost or dummy atoms and virtual sites, without element (0) and radius: 1.",
      "Atoms whose types or symbols match no element (Element is 0): 1 (first: R1 of LIG 1)." });
  EXPECT_TRUE(
    Mention(molecule.Notes, "Sections of the MOL2 file that were not read: CRYSIN, SET."));
  EXPECT_FALSE(Mention(molecule.Warnings, "Sections"));
}

TEST(ReadingReport, TypesOfForceFieldsInMOL2AreNoElements)
{
  // GAFF's types in ADP: os is not osmium, nb not niobium, ca not calcium, ho not holmium.
  const auto file = [](const char* types)
  {
    std::string text = "@<TRIPOS>MOLECULE\nx\n5 0\nSMALL\nUSER_CHARGES\n@<TRIPOS>ATOM\n";
    std::string_view rest(types);
    int number = 0;
    for (const char* name : { "O3'", "N7", "C5", "HO2", "CL1" })
    {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      ++number;
      text += std::to_string(number) + " " + name + " " + std::to_string(5 * number) + " 0 0 " +
        std::string(rest.substr(0, end)) + " 1 LIG 0\n";
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return Read(text, MoleculeFormat::MOL2);
  };
  for (const char* types : { "os nb ca ho cl", "OS NB CA HO CL" })
  {
    const Macromolecule molecule = file(types);
    EXPECT_EQ(JoinElements(molecule), "O N C H Cl ") << types;
    EXPECT_TRUE(Mention(molecule.Notes, "are those of a force field, not SYBYL's")) << types;
    EXPECT_TRUE(molecule.Warnings.empty());
  }
  // SYBYL's types take precedence over the names.
  EXPECT_EQ(JoinElements(file("Os N.ar Ca H.spc Cl")), "Os N Ca H Cl ");
}

TEST(ReadingReport, SDF)
{
  const auto atom = [](const char* symbol, const char* code)
  { return std::string("    0.0000    0.0000    0.0000 ") + symbol + " 0" + code + "  0\n"; };
  const std::string atoms = "x\n\n\n  5  3  0  0  0  0            999 V2000\n" +
    atom("N  ", "  3") + atom("O  ", "  5") + atom("R# ", "  0") + atom("Fe ", "  1") +
    atom("C  ", "  z") + "  1  2  1\n  1  9  1\n  u  2  1\n";
  const Macromolecule codes =
    Read(atoms + "M  END\n>  <ID>\n42\n\n> <LOGP>\n2\n\n$$$$\n", MoleculeFormat::SDF);
  EXPECT_EQ(JoinElements(codes), "N O X Fe C ");
  EXPECT_EQ(Charges(codes), "1 -1 ? 3 ? "); // codes 3, 5 and 1 of the format
  EXPECT_EQ(codes.Bonds.size(), 1u);
  ExpectCounts(codes,
    { "Bonds with missing atoms, dropped: 1 (first: line 11).",
      "Unreadable bonds, dropped: 1 (first: line 12).",
      "Codes of charges (columns 37-39) that are not 0 to 7, dropped: 1 (first: line 9).",
      "Atoms whose types or symbols match no element (Element is 0): 1 (first: R#)." });
  EXPECT_TRUE(Mention(codes.Notes, "Data fields of the SDF file that were not read: 2."));
  // M  CHG replaces all codes.
  const Macromolecule lines =
    Read(atoms + "M  CHG  2   4   2   9   1\nM  CHG  x\nM  END\n$$$$\n", MoleculeFormat::SDF);
  EXPECT_EQ(Charges(lines), "? ? ? 2 ? ");
  ExpectCounts(lines,
    { "Charges of missing atoms, dropped: 1 (first: line 13).",
      "Unreadable charges (M  CHG), dropped: 1 (first: line 14)." });
}

TEST(ReadingReport, XYZAndTinker)
{
  // Ghosts of Gaussian, ORCA, Psi4, Q-Chem, NWChem and CP2K; boron is not one.
  const Macromolecule ghosts = Read("8\n\nBq 0 0 0\nH-Bq 1 0 0\nGh(He) 2 0 0\n@O 3 0 0\nbqC 4 0 0\n"
                                    "X 5 0 0\nB 6 0 0\nQq 7 0 0\n",
    MoleculeFormat::XYZ);
  EXPECT_EQ(JoinElements(ghosts), "X X X X X X B X ");
  ExpectCounts(ghosts,
    { "Ghost or dummy atoms and virtual sites, without element (0) and radius: 6.",
      "Atoms whose types or symbols match no element (Element is 0): 1 (first: Qq)." });
  EXPECT_TRUE(Mention(Read("1\n\nC 0 0 0 0.1 0.2 0.3\n", MoleculeFormat::XYZ).Notes,
    "Columns after symbol, x, y and z that were not read: 3."));
  const Macromolecule tinker = Read("2 t\n1 O 0 0 0 1\n2 ** 5 0 0 2\n", MoleculeFormat::XYZ);
  ExpectCounts(tinker, { "match no element (Element is 0): 1 (first: **)." });
}

TEST(ReadingReport, PQR)
{
  const Macromolecule molecule =
    Read("ATOM 1 O WAT 1 0 0 0 0.0 1.7\nATOM 2 EPW WAT 1 0 0 0.2 -1.0 0.0\n"
         "ATOM 3 Bq LIG 2 9 0 0 0.0 1.5\nATOM 4 CO 3CO 3 19 0 0 3.0 1.0\n"
         "ATOM 5 NA HEM 4 29 0 0 0.0 1.5\n",
      MoleculeFormat::PQR);
  EXPECT_EQ(JoinElements(molecule), "O X X Co N ");
  EXPECT_EQ(molecule.Atoms[2].Radius, 1.5); // the file's
  EXPECT_TRUE(Mention(molecule.Notes,
    "Ghost or dummy atoms and virtual sites, with the radii of the file and without element (0): "
    "2."));
  EXPECT_TRUE(molecule.Warnings.empty());
}

TEST(ReadingReport, MMCIF)
{
  const std::string head = "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
                           "_atom_site.label_asym_id\n_atom_site.label_seq_id\n";
  const std::string place = "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
  const Macromolecule names = Read(head + place +
      "OG SER A 1 0 0 0\nHG SER A 1 5 0 0\nCA CA B . 10 0 0\nEPW WAT C . 15 0 0\nCLA CLA D . 20 0 "
      "0\n",
    MoleculeFormat::MMCIF);
  EXPECT_EQ(JoinElements(names), "O H Ca X Cl ");
  ExpectCounts(names,
    { "Atoms without a usable element in the file: 4; decided 4 by residue and atom name.",
      "Ghost or dummy atoms and virtual sites, without element (0) and radius: 1." });
  // X is not an element in a file with known elements, and an unknown element in other files.
  for (const bool hasIds : { true, false })
  {
    const auto id = [hasIds](const char* number) { return std::string(hasIds ? number : ""); };
    const std::string columns =
      head + (hasIds ? "_atom_site.id\n" : "") + "_atom_site.type_symbol\n" + place;
    const Macromolecule some =
      Read(columns + "CB SER A 1 " + id("7") + " C 0 0 0\nUNK UNX B . " + id("9") +
          " X 5 0 0\nC1 LIG C . " + id("12") + " Bq 9 0 0\nSE MSE D 2 " + id("15") + " ? 15 0 0\n",
        MoleculeFormat::MMCIF);
    EXPECT_EQ(JoinElements(some), "C X X Se ");
    ExpectCounts(some,
      { "Atoms without a usable element in the file: 1; decided 1 by residue and atom name.",
        "Ghost or dummy atoms and virtual sites, without element (0) and radius: 2." });
    EXPECT_EQ(JoinElements(Read(columns + "CB SER A 1 " + id("7") + " X 0 0 0\nC1 LIG C . " +
                  id("9") + " X 9 0 0\n",
                MoleculeFormat::MMCIF)),
      "C C ");
  }
  // Impossible elements are replaced; others take precedence over the names.
  const Macromolecule absurd = Read(head + "_atom_site.type_symbol\n" + place +
      "OG SER A 1 OG 0 0 0\nCB SER A 1 C 5 0 0\nCA LIG B . CA 10 0 0\nD1 DOD C . D 15 0 0\n",
    MoleculeFormat::MMCIF);
  EXPECT_EQ(JoinElements(absurd), "O C Ca H ");
  ExpectCounts(absurd,
    { "Elements in the file that the residue does not contain: 1 (first: Og for OG of SER 1 A)." });
  const Macromolecule bonds = Read(head + "_atom_site.type_symbol\n" + place +
      "CB SER A 1 C 5 0 0\nO HOH B . O 9 0 0\nloop_\n_struct_conn.id\n_struct_conn.conn_type_id\n"
      "_struct_conn.ptnr1_label_asym_id\n_struct_conn.ptnr1_label_comp_id\n"
      "_struct_conn.ptnr1_label_seq_id\n_struct_conn.ptnr1_label_atom_id\n"
      "_struct_conn.ptnr2_label_asym_id\n_struct_conn.ptnr2_label_comp_id\n"
      "_struct_conn.ptnr2_label_seq_id\n_struct_conn.ptnr2_label_atom_id\n"
      "_struct_conn.ptnr1_auth_asym_id\n_struct_conn.ptnr1_auth_seq_id\n"
      "_struct_conn.ptnr2_auth_asym_id\n_struct_conn.ptnr2_auth_seq_id\n"
      "c1 covale A SER 1 CB Q LIG . C1 A 1 Q 7\n",
    MoleculeFormat::MMCIF);
  EXPECT_TRUE(bonds.Bonds.empty());
  EXPECT_TRUE(Mention(
    bonds.Notes, "Bonds of struct_conn with atoms that are not in this model, dropped: 1."));
}

TEST(ReadingReport, IsOneWarningOfTheReaderAndFieldData)
{
  const TemporaryFile file(
    "@<TRIPOS>MOLECULE\nx\n2 1\nSMALL\nUSER_CHARGES\n@<TRIPOS>ATOM\n"
    "1 C1 0 0 0 C.3 1 LIG ?\n2 R1 4 0 0 Any 1 LIG 0\n@<TRIPOS>BOND\n1 1 9 1\n",
    "odd.mol2");
  vtkNew<vtkMacromoleculeReader> reader;
  int warnings = 0;
  vtkNew<vtkCallbackCommand> counter;
  counter->SetClientData(&warnings);
  counter->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  reader->AddObserver(vtkCommand::WarningEvent, counter);
  reader->SetFileName(file.Path());
  reader->Update();
  EXPECT_EQ(warnings, 1);
  auto* const notes =
    vtkStringArray::SafeDownCast(reader->GetOutput()->GetFieldData()->GetAbstractArray("Notes"));
  ASSERT_NE(notes, nullptr);
  std::string all;
  for (vtkIdType i = 0; i < notes->GetNumberOfValues(); ++i)
  {
    all += notes->GetValue(i) + "\n";
  }
  for (const char* words : { "Charges that are not numbers, dropped: 1",
         "Bonds with missing atoms, dropped: 1", "match no element" })
  {
    EXPECT_NE(all.find(words), std::string::npos) << words << "\n" << all;
  }
}
