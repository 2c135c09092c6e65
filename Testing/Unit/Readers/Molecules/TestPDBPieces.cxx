// Pieces of a PDB file, read by themselves and joined, beside the file read whole.

#include "Molecules/GemmiStructure.h"
#include "Molecules/MacromoleculeReader.h"
#include "Molecules/PDBPieces.h"
#include "TemporaryFile.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <tuple>

using namespace isthmus;
using isthmus::testing::TemporaryFile;

namespace
{

std::string Line(int serial, const char* name, char altLoc, const char* residue, char chain,
  int number, char insertion, double x, const char* rest, bool hetero = false)
{
  std::array<char, 128> line;
  std::snprintf(line.data(), line.size(), "%-6s%5d %-4s%c%-3s %c%4d%c   %8.3f%8.3f%8.3f%s\n",
    hetero ? "HETATM" : "ATOM", serial, name, altLoc, residue, chain, number, insertion, x, 2 * x,
    -x, rest);
  return line.data();
}

/// Residues of three to nine atoms, some of which come back later in their chain; blank and odd
/// columns, other records and chains in between.
std::string RandomFile(unsigned seed)
{
  std::mt19937 random(seed);
  const auto any = [&random](int n) { return static_cast<int>(random() % unsigned(n)); };
  const char* rests[] = { "  1.00 20.00           C  ", "  0.50  7.25           N1+", "", "  1.00",
    "              SEG1 FE  ", "  1.00 20.00      SEG2 O  " };
  std::string text = "HEADER    SOMETHING\nREMARK   1 NOTHING\n";
  int serial = 0;
  for (int residue = 0; residue < 300; ++residue)
  {
    const char chain = "AABBA"[residue / 60];
    const int number = any(40);
    const char insertion = any(9) == 0 ? 'A' : ' ';
    const bool hetero = any(11) == 0;
    const char* name = std::array{ "ALA", "GLY", "HOH" }[static_cast<std::size_t>(any(3))];
    const int rest = any(6);
    for (int atom = 3 + any(7); atom > 0; --atom)
    {
      const double x = 0.001 * any(100000) - 50.0;
      text +=
        Line(++serial, std::array{ " CA", " N", "1HB", " SG" }[static_cast<std::size_t>(any(4))],
          any(13) == 0 ? 'B' : ' ', name, chain, number, insertion, x, rests[rest], hetero);
      text += any(17) == 0 ? "ANISOU bad\n" : "";
    }
    text += any(31) == 0 ? "TER\n" : "";
  }
  return text + "CONECT    1    2    3\nCONECT    4    5\nEND\n";
}

auto Everything(const Atom& a)
{
  const auto known = [](double value) { return std::isnan(value) ? -1e30 : value; };
  return std::tuple(a.Position, known(a.Radius), known(a.Charge), known(a.BFactor),
    known(a.Occupancy), a.Name, a.ResidueName, a.Chain, a.ResidueId, a.Serial, a.Element,
    a.InsertionCode, a.AltLoc, a.IsHetero);
}

TEST(PDBPieces, AreWhatTheWholeFileIs)
{
  std::size_t joinedOften = 0;
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    const std::string text = RandomFile(seed);
    const Macromolecule whole = ParsePDB(text, "test", {}, {});
    for (const std::size_t bytes : { 100, 1000, 7001, 40000 })
    {
      const auto joined = ReadPDBInPieces(text, "test", bytes, {});
      ASSERT_TRUE(joined) << "seed " << seed << ", pieces of " << bytes;
      joinedOften += 1;
      EXPECT_EQ(joined->Molecule.NumberOfModels, whole.NumberOfModels);
      ASSERT_EQ(joined->Molecule.Atoms.size(), whole.Atoms.size());
      for (std::size_t i = 0; i < whole.Atoms.size(); ++i)
      {
        ASSERT_EQ(Everything(joined->Molecule.Atoms[i]), Everything(whole.Atoms[i]))
          << "atom " << i << ", pieces of " << bytes;
      }
      const std::vector<std::array<int, 2>> bonded{ { 1, 2 }, { 1, 3 }, { 4, 5 } };
      EXPECT_EQ(joined->Bonded, bonded);
    }
  }
  EXPECT_EQ(joinedOften, 20u);
}

/// A short SSBOND record names no atoms, but makes the reader take the file whole.
TEST(PDBPieces, AreTakenForLargeFilesByThemselves)
{
  std::string text;
  for (unsigned seed = 1; text.size() < (std::size_t{ 9 } << 20); ++seed)
  {
    const std::string more = RandomFile(seed);
    text += more.substr(0, more.find("CONECT"));
  }
  ASSERT_TRUE(ReadPDBInPieces(text, "test", std::size_t{ 1 } << 22, {}));
  const Macromolecule pieces = ParsePDB(text, "test", {}, {});
  const Macromolecule whole = ParsePDB("SSBOND\n" + text, "test", {}, {});
  ASSERT_EQ(pieces.Atoms.size(), whole.Atoms.size());
  for (std::size_t i = 0; i < whole.Atoms.size(); ++i)
  {
    ASSERT_EQ(Everything(pieces.Atoms[i]), Everything(whole.Atoms[i])) << "atom " << i;
  }
  EXPECT_EQ(pieces.Bonds.size(), whole.Bonds.size());
}

TEST(PDBPieces, RefuseWhatHangsOnTheWholeFile)
{
  const std::string atoms = RandomFile(1);
  const std::string more = Line(1, " CA", ' ', "ALA", 'Z', 1, ' ', 1.0, "");
  for (const std::string record : { "MODEL        1\n", "ENDMDL\n", "SSBOND   1 CYS A    1\n",
         "link         FE\n", "CISPEP\n", "END\n" })
  {
    EXPECT_FALSE(ReadPDBInPieces(record + atoms + more, "test", 1000, {})) << record;
    EXPECT_FALSE(ReadPDBInPieces(atoms + record + atoms, "test", 1000, {})) << record;
  }
  EXPECT_FALSE(ReadPDBInPieces(atoms, "test", atoms.size(), {})) << "one piece";
  EXPECT_FALSE(ReadPDBInPieces(
    atoms.substr(0, atoms.size() - 4) + "ATOM  no coordinates\n", "test", 1000, {}));
}

TEST(PDBPieces, StopWhenAsked)
{
  EXPECT_THROW(
    ReadPDBInPieces(RandomFile(1), "test", 100, [](double) { return false; }), Cancelled);
}

TEST(PDBPieces, ModelsAreCountedWhereverTheyBegin)
{
  // Records across the ends of the parts that are counted by themselves, one MiB each.
  constexpr std::size_t part = 1 << 20;
  for (std::size_t shift = 0; shift < 10; ++shift)
  {
    std::string text = "MODEL        1\n";
    text += std::string(part - text.size() - shift, '\n') + "MODEL        2\n" + " MODEL \n";
    text += std::string(2 * part - text.size() - shift, '\n') + "MODEL        3\n";
    const TemporaryFile file(text, "models.pdb");
    EXPECT_EQ(CountModels(file.Path(), MoleculeFormat::ByName), 3) << "shift " << shift;
  }
}

}
