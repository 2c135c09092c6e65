// Models whose side chains or bases are missing.

#include "Atoms/PolymerAtoms.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace isthmus;

namespace
{

/// Residues with these atoms.
std::vector<NamedAtom> Chain(const std::vector<std::string>& residues,
  const std::vector<std::string>& names, const std::string& chain = "A")
{
  std::vector<NamedAtom> atoms;
  for (std::size_t r = 0; r < residues.size(); ++r)
  {
    for (const std::string& name : names)
    {
      NamedAtom atom;
      atom.Name = name;
      atom.Residue = residues[r];
      atom.Chain = chain;
      atom.ResidueId = static_cast<int>(r) + 1;
      atom.Element = name[0] == 'H' ? 1 : name[0] == 'P' ? 15 : name[0] == 'N' ? 7 : 6;
      atom.Place = { 4.0 * static_cast<double>(r), 0.0, 0.0 };
      atoms.push_back(atom);
    }
  }
  return atoms;
}

const std::vector<std::string> Peptide{ "LYS", "VAL", "GLY", "PHE", "ALA", "LEU" };
const std::vector<std::string> Backbone{ "N", "H", "CA", "HA", "C", "O", "CB" };

bool Says(const std::vector<NamedAtom>& atoms, const std::string& words)
{
  return DescribeMissingSideChains(atoms).find(words) != std::string::npos;
}

}

TEST(SideChains, MissingOnesAreDescribed)
{
  EXPECT_TRUE(Says(Chain(Peptide, { "CA" }), "chain A: only C-alpha of 6 of 6 residues"))
    << DescribeMissingSideChains(Chain(Peptide, { "CA" }));
  EXPECT_TRUE(Says(Chain(Peptide, Backbone), "only the backbone of 4 of 6 residues"));
  EXPECT_TRUE(Says(Chain({ "UNK", "UNK", "UNK", "UNK", "UNK" }, Backbone), "of 5 of 5"));
  const std::vector<std::string> dna{ "DA", "DC", "DG", "DT", "DA" };
  EXPECT_TRUE(Says(Chain(dna, { "P" }, ""), "(only phosphates of 5 of 5 residues)"));
  EXPECT_TRUE(
    Says(Chain(dna, { "P", "OP1", "OP2", "O5'", "C5'", "C1'" }), "only the backbone of 5 of 5"));
  // One of two chains.
  std::vector<NamedAtom> both = Chain(Peptide, { "N", "CA", "C", "O", "CB", "CG" });
  const std::vector<NamedAtom> bare = Chain(Peptide, { "CA" }, "B");
  both.insert(both.end(), bare.begin(), bare.end());
  EXPECT_TRUE(Says(both, "(chain B: only C-alpha of 6 of 6 residues)"));
}

TEST(SideChains, CompleteModelsBeadsAndFragmentsAreNot)
{
  EXPECT_EQ(DescribeMissingSideChains(Chain(Peptide, { "N", "CA", "C", "O", "CB", "CG" })), "");
  EXPECT_EQ(DescribeMissingSideChains(
              Chain({ "GLY", "ALA", "GLY", "ALA", "GLY" }, { "N", "CA", "C", "O", "CB" })),
    "");
  EXPECT_EQ(DescribeMissingSideChains(Chain(Peptide, { "BB", "SC1" })), "");
  EXPECT_EQ(DescribeMissingSideChains(Chain({ "LYS", "VAL" }, { "CA" })), "");
  EXPECT_EQ(
    DescribeMissingSideChains(Chain({ "DA", "DC", "DG", "DT", "DA" }, { "P", "C1'", "N9" })), "");
  EXPECT_EQ(DescribeMissingSideChains({}), "");
}
