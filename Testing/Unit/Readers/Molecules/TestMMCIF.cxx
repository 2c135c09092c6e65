// The part of an mmCIF file that gemmi parses: only required categories, and only numbers that an
// int can hold.

#include "MoleculeTexts.h"

#include <gtest/gtest.h>

#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Two atoms; the second has the given `id`, `label`, `residue` and `charge`.
std::string TwoAtoms(const std::string& id, const std::string& label, const std::string& residue,
  const std::string& charge)
{
  std::string text = "data_X\nloop_\n";
  for (const char* tag : { "group_PDB", "id", "type_symbol", "label_atom_id", "label_alt_id",
         "label_comp_id", "label_asym_id", "label_seq_id", "Cartn_x", "Cartn_y", "Cartn_z",
         "occupancy", "B_iso_or_equiv", "auth_seq_id", "pdbx_formal_charge", "pdbx_PDB_model_num" })
  {
    text += std::string("_atom_site.") + tag + "\n";
  }
  text += "ATOM 1 N N . LYS A 1 0 0 0 1 ? 1 ? 1\n";
  text +=
    "ATOM " + id + " C CA . LYS A " + label + " 1.5 0 0 1 ? " + residue + " " + charge + " 1\n";
  return text + "#\n";
}

std::string Why(const std::string& text)
{
  return CatchMessage(text, MoleculeFormat::MMCIF);
}

}

// Found by FuzzMacromoleculeReader: gemmi adds up digits beyond the range of an int.
TEST(MMCIF, NumbersThatNoIntHoldsAreRefusedByTheirColumn)
{
  ASSERT_EQ(Why(TwoAtoms("2", "1", "1", "0")), "");
  EXPECT_EQ(Why(TwoAtoms("999999999", "1", "-99999999", "0")), "");
  const std::string large = "3333333333";
  EXPECT_NE(Why(TwoAtoms(large, "1", "1", "0")).find("_atom_site.id"), std::string::npos);
  EXPECT_NE(Why(TwoAtoms("2", large, "1", "0")).find("label_seq_id"), std::string::npos);
  EXPECT_NE(Why(TwoAtoms("2", "1", "-" + large, "0")).find("auth_seq_id"), std::string::npos);
  EXPECT_NE(Why(TwoAtoms("2", "1", large + "A", "0")).find("auth_seq_id"), std::string::npos);
  EXPECT_NE(Why(TwoAtoms("2", "1", "1", large)).find("formal_charge"), std::string::npos);
}

TEST(MMCIF, MalformedUnusedCategoriesDropNoAtoms)
{
  const std::string atoms = TwoAtoms("2", "1", "1", "0");
  const std::string helix = "_struct_conf.conf_type_id HELX_P\n_struct_conf.beg_auth_asym_id A\n"
                            "_struct_conf.beg_label_comp_id LYS\n_struct_conf.beg_auth_seq_id one\n"
                            "_struct_conf.end_auth_asym_id A\n_struct_conf.end_label_comp_id LYS\n"
                            "_struct_conf.end_auth_seq_id 99999999999\n";
  EXPECT_EQ(JoinNames(ParseMolecule(atoms + helix, MoleculeFormat::MMCIF)), "N CA ");
}
