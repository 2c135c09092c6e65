// Elements of PDB files without an element column, with a wrong one, and of names that are not
// elements. Names are those of the programs' topology files: CHARMM36 (top_all36_prot, _lipid,
// water_ions), AMBER (amino12, lipid17, frcmod ions), GROMACS (amber99sb, gromos54a7), OPLS
// (LigParGen), Martini.

#include "Molecules/AtomElements.h"
#include "PDBText.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// An atom, as it is in columns 13-16, and its residue, as in 18-21.
struct Named
{
  const char* Name;
  const char* Residue;
  const char* Element;
};

/// Reads atoms 5 angstrom apart, without element columns; each row is a residue of its own unless
/// it has the same name as the row before.
void ExpectElements(const std::vector<Named>& atoms)
{
  std::string text;
  std::string expected;
  int number = 0;
  double x = 0.0;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    number += i == 0 || std::string(atoms[i].Residue) != atoms[i - 1].Residue ? 1 : 0;
    std::array<char, 32> residue;
    std::snprintf(residue.data(), residue.size(), "%-4s %4d ", atoms[i].Residue, number);
    text += AtomLine(std::to_string(i + 1), atoms[i].Name, residue.data(), x += 5.0);
    expected += std::string(atoms[i].Element) + " ";
  }
  EXPECT_EQ(JoinElements(FromPDB(text)), expected);
}

std::map<std::string, int> Counts(const Macromolecule& molecule)
{
  std::map<std::string, int> counts;
  for (const Atom& atom : molecule.Atoms)
  {
    ++counts[ElementSymbol(atom.Element)];
  }
  return counts;
}

std::map<std::pair<int, int>, int> ElementsByResidue(const Macromolecule& molecule)
{
  std::map<std::pair<int, int>, int> counts;
  for (const Atom& atom : molecule.Atoms)
  {
    ++counts[{ atom.ResidueId, atom.Element }];
  }
  return counts;
}

}

TEST(AtomElements, ReportedFiles)
{
  const Macromolecule adk = FromReport("adk_open.pdb.gz");
  const std::map<std::string, int> right{ { "N", 289 }, { "H", 1685 }, { "C", 1040 }, { "S", 7 },
    { "O", 320 } };
  EXPECT_EQ(Counts(adk), right);
  EXPECT_TRUE(Mention(adk.Warnings, "77-78: 3341; decided 3341 by residue and atom name."));
  const Macromolecule pqr = FromReport("adk_open.pqr");
  EXPECT_EQ(ElementsByResidue(adk), ElementsByResidue(pqr)); // whose atoms have another order

  const Macromolecule box = FromReport("amoeba-ion-in-water.pdb");
  const std::map<std::string, int> water{ { "Ca", 1 }, { "O", 215 }, { "H", 430 } };
  EXPECT_EQ(Counts(box), water);
  EXPECT_EQ(Describe(box.Atoms.back()), "Ca of Ca 216");

  const Macromolecule beads = FromReport("p21_martini.pdb");
  EXPECT_EQ(Counts(beads), (std::map<std::string, int>{ { "X", 11 } }));
  EXPECT_TRUE(Mention(beads.Warnings, "(Martini), without element (0) and radius: 11."));
  EXPECT_TRUE(std::isnan(beads.Atoms[0].Radius));
  EXPECT_EQ(Describe(beads.Atoms[7]), "NC3 of POPC 4");
}

TEST(AtomElements, CHARMM)
{
  ExpectElements({ { "N", "HSD", "N" }, { "HN", "HSD", "H" }, { "CA", "HSD", "C" },
    { "CE1", "HSD", "C" }, { "ND1", "HSD", "N" }, { "HE1", "HSD", "H" }, { "OT1", "GLY", "O" },
    { "HG1", "SER", "H" }, { "CD", "ARG", "C" }, { "HH11", "ARG", "H" }, { "SG", "CYS", "S" },
    { "FE", "HEME", "Fe" }, { "NA", "HEME", "N" }, { "CHA", "HEME", "C" }, { "HA", "HEME", "H" },
    { "SOD", "SOD", "Na" }, { "POT", "POT", "K" }, { "CLA", "CLA", "Cl" }, { "CAL", "CAL", "Ca" },
    { "CES", "CES", "Cs" }, { "MG", "MG", "Mg" }, { "ZN", "ZN2", "Zn" }, { "LIT", "LIT", "Li" },
    { "RUB", "RUB", "Rb" }, { "CD", "CD2", "Cd" }, { "OH2", "TIP3", "O" }, { "H1", "TIP3", "H" },
    { "P", "POPC", "P" }, { "C12", "POPC", "C" }, { "H12A", "POPC", "H" }, { "O11", "POPC", "O" },
    { "N", "POPC", "N" }, { "C1B", "CHL1", "C" }, { "NB", "ADE", "N" } });
}

TEST(AtomElements, AMBER)
{
  ExpectElements({ { "N", "NALA", "N" }, { "H1", "NALA", "H" }, { "HB3", "CASP", "H" },
    { "CG", "ASH", "C" }, { "SD", "MET", "S" }, { "HD2", "HID", "H" }, { "P", "DA5", "P" },
    { "OP1", "DG3", "O" }, { "HO5'", "DA5", "H" }, { "C1'", "RU", "C" }, { "Na+", "Na+", "Na" },
    { "Cl-", "Cl-", "Cl" }, { "K+", "K+", "K" }, { "Cs+", "Cs+", "Cs" }, { "MG", "MG", "Mg" },
    { "ZN", "ZN", "Zn" }, { "CA", "CA", "Ca" }, { "O", "WAT", "O" }, { "H1", "WAT", "H" },
    { "EPW", "WAT", "X" }, { "C31", "PA", "C" }, { "N31", "PC", "N" } });
}

TEST(AtomElements, GROMACSAndOPLS)
{
  // Right-justified symbols of one letter, ions in residues of their own or in ION.
  ExpectElements({ { " N", "LYSH", "N" }, { " CA", "LYSH", "C" }, { " HZ1", "LYSH", "H" },
    { " CG", "HISB", "C" }, { " CD1", "TRP", "C" }, { " OW", "SOL", "O" }, { " HW1", "SOL", "H" },
    { " MW", "SOL", "X" }, { " NA", "NA", "Na" }, { " CL", "CL", "Cl" }, { " NA+", "ION", "Na" },
    { " CL-", "ION", "Cl" }, { " CA2+", "ION", "Ca" }, { " ZN", "ZN", "Zn" }, { " K", "K", "K" },
    // LigParGen and BOSS: numbered names.
    { " C00", "UNK", "C" }, { " H0A", "UNK", "H" }, { "CL0B", "UNK", "Cl" },
    { "BR0C", "UNK", "Br" }, { " O01", "UNK", "O" }, { " S02", "UNK", "S" } });
}

TEST(AtomElements, CofactorsAndChlorideAreDistinguished)
{
  // CLA is chlorophyll a in the PDB, chloride in CHARMM.
  ExpectElements({ { "MG", "CLA", "Mg" }, { " CHA", "CLA", "C" }, { " NA", "CLA", "N" },
    { " O1D", "CLA", "O" }, { " FE", "HEM", "Fe" }, { " NA", "HEM", "N" }, { "FE1", "SF4", "Fe" },
    { " S1", "SF4", "S" }, { " CO", "B12", "Co" }, { " PG", "ATP", "P" }, { " N9", "ATP", "N" },
    { "SE", "MSE", "Se" }, { " CE", "MSE", "C" } });
}

TEST(AtomElements, ColumnsOfNamesInUnknownResidues)
{
  const std::string known =
    AtomLine("1", " CA", "ALA A   1 ", 0) + AtomLine("2", " N", "ALA A   1 ", -1.4);
  // Isolated, and at the distance of a bond.
  const auto ligand = [&](const char* name, double distance)
  {
    return JoinElements(FromPDB(known + AtomLine("3", " O1", "XYZ A   2 ", 50) +
                          AtomLine("4", name, "XYZ A   2 ", 50 + distance)))
      .substr(6);
  };
  EXPECT_EQ(ligand("CA", 2.4), "Ca ");
  EXPECT_EQ(ligand("CA", 1.5), "C ");
  EXPECT_EQ(ligand(" CA", 2.4), "C ");
  EXPECT_EQ(ligand("HG", 2.1), "Hg ");
  EXPECT_EQ(ligand("HG", 1.0), "H ");
  EXPECT_EQ(ligand("CD", 2.3), "Cd ");
  EXPECT_EQ(ligand("CL", 1.7), "Cl "); // non-metals have short bonds
  EXPECT_EQ(ligand("HE11", 1.0), "H ");
  EXPECT_EQ(ligand("1HA", 1.0), "H ");
  EXPECT_EQ(ligand("OG", 1.5), "O "); // never oganesson
  EXPECT_EQ(ligand("OG", 2.5), "O ");
  // A ligand whose name is that of an ion in CHARMM.
  EXPECT_EQ(JoinElements(FromPDB(
              AtomLine("1", "CA", "CAL A   1 ", 0) + AtomLine("2", "CB", "CAL A   1 ", 1.5))),
    "C C ");
  // Left-justified names of a known residue: columns have no meaning.
  const std::string left =
    AtomLine("1", "CA", "ALA A   1 ", 0) + AtomLine("2", "N", "ALA A   1 ", -1.4);
  EXPECT_EQ(JoinElements(FromPDB(left + AtomLine("3", "CD1", "XYZ A   2 ", 50) +
              AtomLine("4", "HG", "XYZ A   2 ", 60))),
    "C N C H ");
  const Macromolecule counted = FromPDB(
    known + AtomLine("3", "HG", "XYZ A   2 ", 50) + AtomLine("4", "C10A", "XYZ A   2 ", 60));
  EXPECT_TRUE(Mention(counted.Warnings,
    "Atoms without a usable element in columns 77-78: 4; decided 2 by residue and atom name, 1 by "
    "the "
    "columns of the name, 1 by the letters of the name."))
    << counted.Warnings[0];
}

TEST(AtomElements, MetalsAreKnownByTheirLigands)
{
  // Left-justified, in residues that are not known: cobalt with nitrogens at 1.9 angstrom, and the
  // same name as a carbon at the end of a chain, or far from all others, as in traces of C-alphas.
  const auto center = [](const char* name, double distance)
  {
    return JoinElements(
      FromPDB(AtomLine("1", name, "B1Z A   1 ", 0) + AtomLine("2", "N21", "B1Z A   1 ", distance) +
        AtomLine("3", "N22", "B1Z A   1 ", 0, distance) +
        AtomLine("4", "N23", "B1Z A   1 ", -distance)))
      .substr(0, 2);
  };
  EXPECT_EQ(center("CO", 1.9), "Co");
  EXPECT_EQ(center("CO", 1.5), "C ");
  EXPECT_EQ(center("CO", 3.8), "C ");
  EXPECT_EQ(center("CD", 2.3), "Cd");
  EXPECT_EQ(center("CA", 2.4), "Ca");
  EXPECT_EQ(center("CO1", 1.9), "C ");
  // An unambiguous symbol, in any column; a lower-case letter.
  EXPECT_EQ(center("IR", 1.5), "Ir");
  EXPECT_EQ(center("RU", 3.8), "Ru");
  EXPECT_EQ(center("Co1", 1.9), "Co");
  EXPECT_EQ(center("Br1", 1.9), "Br");
  EXPECT_EQ(ElementFromAtomName("Li", "LI"), 3); // of GRO files
  EXPECT_EQ(ElementFromAtomName("IR1", "LIG"), 53);
  EXPECT_EQ(ElementFromAtomName("CO", "3CO"), 27); // oxidation states of the PDB
  EXPECT_EQ(ElementFromAtomName("PA", "1PA"), 15);
  EXPECT_EQ(ElementFromAtomName("C1", "1CO"), 6);
  EXPECT_EQ(ElementFromAtomName("HG", "LIG"), 1);
  EXPECT_EQ(ElementFromAtomName("Cd1", "LEU"), 6);
}

TEST(AtomElements, AnElementColumnWinsUnlessItIsAbsurd)
{
  const auto with = [](const char* name, const char* residue, const char* symbol)
  { return AtomLine("1", name, residue, 0, 0, 0, std::string("  1.00  0.00          ") + symbol); };
  EXPECT_EQ(JoinElements(FromPDB(with("CA", "LIG A   1 ", "CA"))), "Ca ");
  EXPECT_EQ(JoinElements(FromPDB(with(" CA", "LIG A   1 ", "CA"))), "Ca ");
  EXPECT_EQ(JoinElements(FromPDB(with("CLA", "CLA A   1 ", "CL"))), "Cl ");
  EXPECT_EQ(JoinElements(FromPDB(with("SE", "MSE A   1 ", "SE"))), "Se ");
  EXPECT_EQ(JoinElements(FromPDB(with(" D1", "DOD A   1 ", " D"))), "H ");
  EXPECT_EQ(JoinElements(FromPDB(with("N", "ALA A   1 ", "N "))), "N ");
  EXPECT_EQ(JoinElements(FromPDB(with("N", "ALA A   1 ", "N1+"))), "N ");
  EXPECT_TRUE(FromPDB(with(" CA", "ALA A   1 ", " C")).Warnings.empty());
  // Names in the wrong columns: oganesson, mercury, calcium, cadmium in a protein.
  const Macromolecule absurd = FromPDB(with(" OG", "SER A   1 ", "OG") +
    with(" HG", "SER A   1 ", "HG") + with(" CA", "SER A   1 ", "CA") +
    with(" CB", "SER A   1 ", " C") + with(" OH2", "HOH A   2 ", "NA"));
  EXPECT_EQ(JoinElements(absurd), "O H C C O ");
  EXPECT_EQ(JoinElements(FromPDB(with(" OG", "SEP A   1 ", "OG") + with(" CA", "POPC    2 ", "CA") +
              with(" OG", "LIG A   3 ", "OG") + with("SE", "MSE A   4 ", "SE"))),
    "O C O Se ");
  EXPECT_TRUE(Mention(
    absurd.Warnings, "that the residue does not contain: 4 (first: Og for OG of SER 1 A)."));
}

TEST(AtomElements, RecognisesDummies)
{
  const auto with = [](const char* name, const char* residue, const char* symbol)
  {
    return FromPDB(
      AtomLine("1", name, residue, 0, 0, 0, std::string("  1.00  0.00          ") + symbol, true));
  };
  // Ghost atoms of counterpoise corrections, dummies, lone pairs, virtual sites; OPM's membrane.
  for (const auto& [name, residue, symbol] : std::vector<std::array<const char*, 3>>{
         { "Bq", "LIG A   1 ", "Bq" }, { "O1", "LIG A   1 ", "Gh" }, { "X1", "LIG A   1 ", " X" },
         { " X", "LIG A   1 ", "  " }, { "BQ1", "LIG A   1 ", "  " }, { "DU", "LIG A   1 ", "  " },
         { "LP1", "MET A   1 ", "LP" }, { "EPW", "WAT A   1 ", "EP" }, { "M", "TIP4    1 ", "  " },
         { " O", "DUM     1 ", "  " }, { " N", "DUM     1 ", " N" } })
  {
    const Macromolecule molecule = with(name, residue, symbol);
    EXPECT_EQ(JoinElements(molecule), "X ") << name << residue << symbol;
    EXPECT_TRUE(std::isnan(molecule.Atoms[0].Radius)) << name;
    EXPECT_TRUE(Mention(molecule.Warnings,
      "Ghost or dummy atoms and virtual sites, without element (0) and radius: 1."))
      << name;
  }
  const Macromolecule pseudo = with("QB", "ALA A   1 ", "  ");
  EXPECT_EQ(JoinElements(pseudo), "X ");
  EXPECT_TRUE(
    Mention(pseudo.Warnings, "match no element (Element is 0): 1 (first: QB of ALA 1 A)"));
}

TEST(AtomElements, BeadsOfMartini)
{
  // Martini 2 protein and lipid, Martini 3 water and ions, DNA; beads that are named as atoms.
  ExpectElements({ { "BB", "ALA", "X" }, { "SC1", "PHE", "X" }, { "BB", "PHE", "X" },
    { "NH3", "DPPE", "X" }, { "C1A", "DPPE", "X" }, { "PO4", "DPPE", "X" }, { "W", "W", "X" },
    { "NA", "ION", "X" }, { "CL", "ION", "X" } });
  ExpectElements({ { "BB1", "DA", "X" }, { "SC1", "DA", "X" }, { "BB2", "DA", "X" } });
  ExpectElements({ { "ROH", "CHOL", "X" }, { "C1", "CHOL", "X" }, { "WF", "WF", "X" } });
  // In a file with an atomistic protein, only residues that have beads are beads.
  ExpectElements({ { "N", "ALA", "N" }, { "CA", "ALA", "C" }, { "C", "ALA", "C" },
    { "O", "ALA", "O" }, { "CB", "ALA", "C" }, { "NA", "NA", "Na" }, { "W", "W", "X" } });
}

TEST(AtomElements, FamiliesOfResidues)
{
  EXPECT_EQ(FindResidueFamily("HSP"), ResidueFamily::AminoAcid);
  EXPECT_EQ(FindResidueFamily("NHIE"), ResidueFamily::AminoAcid);
  EXPECT_EQ(FindResidueFamily("DG5"), ResidueFamily::Nucleotide);
  EXPECT_EQ(FindResidueFamily("OPC3"), ResidueFamily::Water);
  EXPECT_EQ(FindResidueFamily("SAPI"), ResidueFamily::Lipid);
  EXPECT_EQ(FindResidueFamily("NAP"), ResidueFamily::Cofactor);
  EXPECT_EQ(FindResidueFamily("LIG"), ResidueFamily::Unknown);
  EXPECT_EQ(FindResidueFamily(""), ResidueFamily::Unknown);
  EXPECT_TRUE(IsLongResidueName("TIP3") && IsLongResidueName("LYSH") && IsLongResidueName("DOPS"));
  EXPECT_FALSE(IsLongResidueName("ALA") || IsLongResidueName("ALAB") || IsLongResidueName("LIGX"));
  EXPECT_EQ(ElementFromAtomName("SOD", "SOD"), 11); // of PQR and GRO files as well
  EXPECT_EQ(ElementFromAtomName("CLA", "CLA"), 17);
}
