// Helices and strands that files describe.

#include "MoleculeTexts.h"
#include "PDBText.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// CA of residues 1 to `last` of chains A and B.
std::string Traces(int last)
{
  std::string text;
  for (const char chain : { 'A', 'B' })
  {
    for (int r = 1; r <= last; ++r)
    {
      std::array<char, 16> residue;
      std::snprintf(residue.data(), residue.size(), "ALA %c%4d ", chain, r);
      text +=
        AtomLine(std::to_string(r), " CA ", residue.data(), 3.8 * r, chain == 'A' ? 0.0 : 9.0);
    }
  }
  return text + "END\n";
}

/// One digit for each atom, "-" where there is none.
std::string FindStructure(const Macromolecule& molecule)
{
  std::string digits;
  for (const Atom& atom : molecule.Atoms)
  {
    digits += atom.Structure == Atom::NoStructure ? "-" : std::to_string(atom.Structure);
  }
  return digits;
}

std::string FindStructure(const std::string& records)
{
  return FindStructure(FromPDB(records + Traces(6)));
}

}

TEST(StructureRecords, HelicesAndStrandsOfPDB)
{
  EXPECT_EQ(FindStructure(""), "------------");
  EXPECT_EQ(
    FindStructure("HELIX    1  H1 ALA A    2  ALA A    4  1                                   3\n"
                  "SHEET    1   A 2 ALA B   1  ALA B   2  0\n"),
    "011100220000");
  // 3-10, pi and polyproline; a helix comes before a strand.
  EXPECT_EQ(FindStructure("HELIX    1  H1 ALA A    1  ALA A    2  5\n"
                          "HELIX    2  H2 ALA A    3  ALA A    3  3\n"
                          "HELIX    3  H3 ALA B    1  ALA B    2 10\n"
                          "SHEET    1   A 2 ALA A   1  ALA A   4  0\r\n"),
    "334200000000");
}

TEST(StructureRecords, RecordsThatCannotBeReadAreIgnored)
{
  EXPECT_EQ(
    FindStructure("HELIX\nHELIX    1  H1 ALA A  two  ALA A    4  1\nSHEET    1   A 2 ALA A\n"),
    "------------");
  EXPECT_EQ(FindStructure("HELIX    1  H1 ALA C    2  ALA C    4  1\n"), "------------");
}

TEST(StructureRecords, HelicesAndStrandsOfMMCIF)
{
  std::string atoms = "data_X\nloop_\n";
  for (const char* tag : { "group_PDB", "id", "type_symbol", "label_atom_id", "label_alt_id",
         "label_comp_id", "label_asym_id", "label_seq_id", "Cartn_x", "Cartn_y", "Cartn_z",
         "auth_seq_id", "auth_asym_id", "pdbx_PDB_ins_code" })
  {
    atoms += std::string("_atom_site.") + tag + "\n";
  }
  for (int r = 1; r <= 6; ++r)
  {
    const std::string n = std::to_string(r);
    atoms +=
      "ATOM " + n + " C CA . ALA A " + n + " " + n + " 0 0 " + std::to_string(r + 10) + " Q ?\n";
  }
  const std::string helices = "loop_\n_struct_conf.conf_type_id\n_struct_conf.beg_auth_asym_id\n"
                              "_struct_conf.beg_auth_seq_id\n_struct_conf.end_auth_seq_id\n"
                              "_struct_conf.pdbx_PDB_helix_class\n";
  const auto structure = [&](const std::string& rows)
  { return FindStructure(ParseMolecule(atoms + rows + "#\n", MoleculeFormat::MMCIF)); };
  EXPECT_EQ(structure(""), "------");
  EXPECT_EQ(structure(helices +
              "HELX_P Q 11 12 1\nHELX_P Q 13 13 5\nTURN_P Q 16 16 ?\n#\nloop_\n"
              "_struct_sheet_range.beg_auth_asym_id\n_struct_sheet_range.beg_auth_seq_id\n"
              "_struct_sheet_range.end_auth_seq_id\nQ 14 15\n"),
    "113220");
  // As ModelCIF of predictions has them, and a row that is unusable.
  EXPECT_EQ(structure(helices +
              "HELX_RH_AL_P Q 11 11 ?\nSTRN Q 12 12 ?\nHELX_RH_3T_P Q 13 13 ?\n"
              "HELX_RH_PI_P Q 14 14 ?\nHELX_LH_PP_P Q 15 15 ?\nSTRN Q ? 16 ?\n"),
    "123400");
}

TEST(StructureRecords, ConfidenceOfPredictedModels)
{
  const auto model = [](const std::string& head, const char* first, const char* second)
  {
    const auto atom = [](const char* name, int number, const char* b)
    {
      return "ATOM      1  " + std::string(name) + " GLY A   " + std::to_string(number) +
        "       " + std::to_string(number) + ".000   0.000   0.000  1.00" + b + "           C  \n";
    };
    return ParseMolecule(
      head + atom("CA ", 1, " 91.25") + atom("C  ", 1, first) + atom("CA ", 2, second),
      MoleculeFormat::PDB);
  };
  const std::string alphaFold = "TITLE     ALPHAFOLD MONOMER V2.0 PREDICTION FOR GLUTAREDOXIN\n";
  const Macromolecule predicted = model(alphaFold, " 91.25", " 38.50");
  EXPECT_EQ(predicted.Atoms.at(1).PLDDT, 91.25);
  EXPECT_EQ(predicted.Atoms.at(2).PLDDT, 38.5);
  EXPECT_EQ(predicted.Atoms.at(2).BFactor, 38.5);
  const auto isNone = [](const Macromolecule& molecule)
  { return std::isnan(molecule.Atoms.at(0).PLDDT); };
  EXPECT_FALSE(isNone(model("TITLE     ESMFOLD V1 PREDICTION FOR INPUT\n", " 91.25", " 38.50")));
  EXPECT_TRUE(isNone(model("", " 91.25", " 38.50")));
  EXPECT_TRUE(isNone(model(alphaFold, " 90.00", " 38.50"))); // differs within a residue
  EXPECT_TRUE(isNone(model(alphaFold, " 91.25", "138.50")));
  EXPECT_TRUE(isNone(model(
    "TITLE     AN ALPHAFOLD MODEL REFINED\nEXPDTA    X-RAY DIFFRACTION\n", " 91.25", " 38.50")));
  // ESMFold writes fractions.
  const Macromolecule fractions = ParseMolecule(
    "TITLE     ESMFOLD V1 PREDICTION FOR INPUT\n"
    "ATOM      1  CA  GLY A   1       1.000   0.000   0.000  1.00  0.90           C  \n",
    MoleculeFormat::PDB);
  EXPECT_NEAR(fractions.Atoms.at(0).PLDDT, 90.0, 1e-9);
}
