// PDB files in pieces, the columns that simulation programs write, and records that are unusable.

#include "Molecules/MacromoleculeReader.h"
#include "Molecules/PDBColumns.h"
#include "Molecules/PDBFile.h"
#include "Molecules/ReadingReport.h"
#include "PDBText.h"
#include "TemporaryFile.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <tuple>

using namespace isthmus;
using namespace isthmus::testing;

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

/// Residues of three to nine atoms, some of which recur later in their chain; blank and odd
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

auto Everything(const Bond& b)
{
  return std::tuple(b.First, b.Second, b.FromFile);
}

template <typename T>
void ExpectSame(const std::vector<T>& a, const std::vector<T>& b, const std::string& where)
{
  ASSERT_EQ(a.size(), b.size()) << where;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    ASSERT_EQ(Everything(a[i]), Everything(b[i])) << i << " of " << where;
  }
}

/// Reads `text` in pieces of several sizes, which must give what one piece gives.
Macromolecule SameInPieces(const std::string& text, const std::string& what)
{
  Macromolecule whole = ParsePDB(text, "test", {}, {}, text.size() + 1);
  for (const std::size_t bytes : { 100, 1000, 7001, 40000 })
  {
    const Macromolecule pieces = ParsePDB(text, "test", {}, {}, bytes);
    const std::string where = what + ", pieces of " + std::to_string(bytes);
    EXPECT_EQ(pieces.NumberOfModels, whole.NumberOfModels) << where;
    EXPECT_EQ(pieces.Notes, whole.Notes) << where;
    EXPECT_EQ(pieces.Warnings, whole.Warnings) << where;
    ExpectSame(pieces.Atoms, whole.Atoms, where);
    ExpectSame(pieces.Bonds, whole.Bonds, where);
  }
  return whole;
}

TEST(PDBPieces, MatchTheWholeFile)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    const Macromolecule whole = SameInPieces(RandomFile(seed), "seed " + std::to_string(seed));
    EXPECT_GT(whole.Atoms.size(), 900u);
    // 1 to 2 and 3, and 4 to 5.
    EXPECT_EQ(whole.Bonds.size(), 3u);
  }
}

TEST(PDBPieces, AreUsedForLargeFilesAutomatically)
{
  std::string text;
  for (unsigned seed = 1; text.size() < (std::size_t{ 9 } << 20); ++seed)
  {
    const std::string more = RandomFile(seed);
    text += more.substr(0, more.find("CONECT"));
  }
  const Macromolecule pieces = ParsePDB(text, "test", {}, {});
  const Macromolecule whole = ParsePDB(text, "test", {}, {}, text.size() + 1);
  ExpectSame(pieces.Atoms, whole.Atoms, "a large file");
  ExpectSame(pieces.Bonds, whole.Bonds, "a large file");
}

/// Records that concern atoms elsewhere in the file may be in any piece.
TEST(PDBPieces, FollowRecordsAcrossPieces)
{
  const std::string atoms = RandomFile(1);
  const std::string more = Line(1, " CA", ' ', "ALA", 'Z', 1, ' ', 1.0, "");
  const std::size_t one = ParsePDB(atoms, "test", {}, {}).Atoms.size();
  const auto sizes = [&](const std::string& text, const std::string& what)
  {
    return std::pair(
      SameInPieces(text, what).NumberOfModels, SameInPieces(text, what).Atoms.size());
  };
  EXPECT_EQ(
    sizes(more + "MODEL        1\n" + atoms, "MODEL"), std::pair(std::int64_t{ 1 }, one + 1));
  EXPECT_EQ(sizes("MODEL        1\n" + atoms + "MODEL        1\n" + more, "two models"),
    std::pair(std::int64_t{ 2 }, one));
  EXPECT_EQ(sizes(atoms + "ENDMDL\n" + more, "ENDMDL"), std::pair(std::int64_t{ 2 }, one));
  EXPECT_EQ(sizes(atoms + more, "END"), std::pair(std::int64_t{ 1 }, one + 1));
  for (const std::string record :
    { "SSBOND   1 CYS A    1\n", "link         FE\n", "CISPEP\n", "TER\n" })
  {
    EXPECT_EQ(sizes(record + atoms, record), std::pair(std::int64_t{ 1 }, one)) << record;
  }
}

TEST(PDBPieces, LinksAreFoundInOtherPieces)
{
  std::string text =
    "SSBOND   1 CYS A    1    CYS B 9000\n"
    "LINK         NE2 HIS A   7                FE   HEM B 142     1555   1555  2.1\n"
    "LINK         NE2 HIS A   7                FE   HEM B 142     1555   2555  2.1\n";
  text += AtomLine("1", " SG", "CYS A   1 ", 0.0, 0.0, 0.0, "  1.00  0.00           S");
  text += AtomLine("2", " NE2", "HIS A   7 ", 0.0, 0.0, 50.0, "  1.00  0.00           N");
  for (int i = 8; i < 500; ++i)
  {
    text += AtomLine("9", " CA", "ALA A" + std::to_string(1000 + i) + " ", 10.0 * i);
  }
  text += AtomLine("3", "FE", "HEM B 142 ", 90.0, 0.0, 0.0, "  1.00  0.00          FE", true);
  text += AtomLine("4", " SG", "CYS B9000 ", 99.0, 0.0, 0.0, "  1.00  0.00           S");
  const Macromolecule molecule = SameInPieces(text, "links");
  ASSERT_EQ(molecule.Bonds.size(), 2u);
  const auto last = static_cast<std::int64_t>(molecule.Atoms.size()) - 1;
  EXPECT_EQ(Everything(molecule.Bonds[0]), std::tuple(std::int64_t{ 0 }, last, true));
  EXPECT_EQ(Everything(molecule.Bonds[1]), std::tuple(std::int64_t{ 1 }, last - 1, true));
}

TEST(PDBRecords, DisulfidesAreBetweenSulfurs)
{
  // SSBOND names no atoms: SG where there is one, else the first sulfur.
  const auto sulfur = [](int serial, const char* name, const char* residue, double x)
  {
    return AtomLine(std::to_string(serial), name, residue, x, 0.0, 0.0, "  1.00  0.00           S");
  };
  const Macromolecule molecule = FromPDB("SSBOND   1 CME A    1    XCN A    2\n" +
    sulfur(1, " SD", "CME A   1 ", 0.0) + sulfur(2, " SG", "CME A   1 ", 9.0) +
    AtomLine("3", " C1", "XCN A   2 ", 18.0, 0.0, 0.0, "  1.00  0.00           C") +
    sulfur(4, " S1", "XCN A   2 ", 27.0));
  ASSERT_EQ(molecule.Bonds.size(), 1u);
  EXPECT_EQ(Everything(molecule.Bonds[0]), std::tuple(std::int64_t{ 1 }, std::int64_t{ 3 }, true));
}

TEST(PDBRecords, AmbiguousSerialsMakeNoBonds)
{
  std::string text;
  for (const int serial : { 1, 2, 3, 2 })
  {
    text += AtomLine(std::to_string(serial), " C1", "LIG A   1 ", 10.0 * serial, 0.0, 0.0,
      "  1.00  0.00           C");
  }
  const Macromolecule molecule = FromPDB(text + "CONECT    1    2    3\nCONECT    2    3\n");
  ASSERT_EQ(molecule.Bonds.size(), 1u);
  EXPECT_EQ(Everything(molecule.Bonds[0]), std::tuple(std::int64_t{ 0 }, std::int64_t{ 2 }, true));
  EXPECT_TRUE(Mention(molecule.Warnings, "with ambiguous serial numbers, dropped: 2"));
}

/// As in gemmi: the first atom of a residue says whether it is a HETATM.
TEST(PDBPieces, AtomsOfAResidueComeTogether)
{
  const Macromolecule molecule = FromPDB(AtomLine("1", " N", "ALA A   1 ", 0) +
    AtomLine("2", " C1", "LIG A   2 ", 9, 0, 0, "", true) +
    AtomLine("3", " CA", "ALA A   1 ", 18, 0, 0, "", true) +
    AtomLine("4", " C2", "LIG A   2 ", 27) + AtomLine("5", " N", "ALA B   1 ", 36, 0, 0, "", true) +
    AtomLine("6", " CB", "ALA A   1 ", 45, 0, 0, "", true));
  EXPECT_EQ(Descriptions(molecule),
    "N of ALA 1 A, CA of ALA 1 A, C1 of LIG 2 A, C2 of LIG 2 A, N of ALA 1 B, CB of ALA 1 A");
  std::string hetero;
  for (const Atom& atom : molecule.Atoms)
  {
    hetero += atom.IsHetero ? '1' : '0';
  }
  EXPECT_EQ(hetero, "001111");
}

TEST(PDBPieces, StopOnRequest)
{
  EXPECT_THROW(ParsePDB(
                 RandomFile(1), "test", {}, [](double) { return false; }, 100),
    Cancelled);
}

TEST(PDBPieces, ModelsAreCountedWhereverTheyBegin)
{
  // Records across the ends of the parts of one MiB each, which are counted separately.
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

// ------------------------------------------------------------------------------------------
// Columns of simulation programs

TEST(PDBColumns, ReportedFiles)
{
  const Macromolecule box = FromReport("5dhfr_cube.pdb.gz");
  std::size_t waters = 0;
  for (const Atom& atom : box.Atoms)
  {
    EXPECT_EQ(atom.Chain, "X");
    waters += atom.ResidueName == "TIP3" ? 1 : 0;
  }
  EXPECT_EQ(box.Atoms.size(), 23558u);
  EXPECT_EQ(waters, 3u * 7023u);

  const Macromolecule five = FromReport("5digitResid.pdb.gz");
  EXPECT_EQ(Descriptions(five),
    "OH2 of TIP3 1 TIP3, OH2 of TIP3 10 TIP3, OH2 of TIP3 100 TIP3, OH2 of TIP3 1000 TIP3, "
    "OH2 of TIP3 10000 TIP3");

  const Macromolecule popc = FromReport("p13_hex_popcl.pdb");
  EXPECT_EQ(Descriptions(popc),
    "O of SER 340 P, H16Y of POPC 1 L, H16Z of POPC 1 L, N of POPC 1 L, C12 of POPC 1 L");
  EXPECT_EQ(popc.Atoms[0].Serial, 99999);
  EXPECT_EQ(popc.Atoms[1].Serial, 100000);
  EXPECT_EQ(popc.Atoms[4].Serial, 116001);
}

TEST(PDBColumns, ResidueNamesOfFourLetters)
{
  // GROMOS96: protonation is the fourth letter, and one protein one chain.
  const Macromolecule gromos =
    FromPDB(AtomLine("1", " CA", "ALA A   1 ", 0) + AtomLine("2", " CA", "LYSHA   2 ", 4) +
      AtomLine("3", " CA", "CYS2A   3 ", 8) + AtomLine("4", " CA", "ARGNA   4 ", 12));
  EXPECT_EQ(Descriptions(gromos), "CA of ALA 1 A, CA of LYSH 2 A, CA of CYS2 3 A, CA of ARGN 4 A");
  // CHARMM-GUI: lipids and water with their segments and no chain.
  const Macromolecule membrane =
    FromPDB(AtomLine("1", " P", "POPE    1 ", 0, 0, 0, "  1.00  0.00      MEMB P") +
      AtomLine("2", " P", "DOPG    2 ", 9, 0, 0, "  1.00  0.00      MEMB P") +
      AtomLine("3", " C3", "CHL1    3 ", 18, 0, 0, "  1.00  0.00      MEMB C") +
      AtomLine("4", " OH2", "TIP3    1 ", 27, 0, 0, "  1.00  0.00      WAT  O"));
  EXPECT_EQ(Descriptions(membrane),
    "P of POPE 1 MEMB, P of DOPG 2 MEMB, C3 of CHL1 3 MEMB, OH2 of TIP3 1 WAT");
  // AMBER: ends of chains; OPLS: an unknown ligand of four letters beside known names.
  const Macromolecule amber = FromPDB(AtomLine("1", " N", "NALA    1 ", 0) +
    AtomLine("2", " N", "CVAL    2 ", 9) + AtomLine("3", " C1", "LIGX    3 ", 18));
  EXPECT_EQ(Descriptions(amber), "N of NALA 1, N of CVAL 2, C1 of LIGX 3");
}

TEST(PDBColumns, ChainsOfTwoLettersStay)
{
  // Columns 21-22, as gemmi and phenix write large assemblies; HIS of chain B2 is not HISB.
  const Macromolecule assembly =
    FromPDB(AtomLine("1", " CA", "ALAB2   1 ", 0) + AtomLine("2", " CA", "HISB2   2 ", 4) +
      AtomLine("3", " CA", "LYSHA   3 ", 8) + AtomLine("4", " CA", "GLYHA   4 ", 12) +
      AtomLine("5", " P", " DAAA   5 ", 16) + AtomLine("6", " CA", "VALAA   6 ", 20));
  EXPECT_EQ(Descriptions(assembly),
    "CA of ALA 1 B2, CA of HIS 2 B2, CA of LYS 3 HA, CA of GLY 4 HA, P of DA 5 AA, CA of VAL 6 AA");
}

std::vector<int> CollectResidueNumbers(const Macromolecule& molecule)
{
  std::vector<int> numbers;
  for (const Atom& atom : molecule.Atoms)
  {
    numbers.push_back(atom.ResidueId);
  }
  return numbers;
}

std::string WaterLines(const std::vector<std::string>& columns23To27, const char* head = "SOL  ")
{
  std::string text;
  double x = 0.0;
  for (const std::string& number : columns23To27)
  {
    text += AtomLine("1", " OW", head + number, x);
    text += AtomLine("2", " HW1", head + number, x + 1.0);
    x += 5.0;
  }
  return text;
}

TEST(PDBColumns, ResidueNumbersFrom10000On)
{
  const std::vector<int> five{ 9998, 9998, 9999, 9999, 10000, 10000, 10001, 10001 };
  // Five digits in 23-27 (CHARMM), hexadecimal (VMD), hybrid-36 (cctbx), starting again (GROMACS,
  // AMBER), asterisks (Fortran).
  for (const std::vector<std::string>& file :
    std::vector<std::vector<std::string>>{ { "9998 ", "9999 ", "10000", "10001" },
      { "9998 ", "9999 ", "2710 ", "2711 " }, { "9998 ", "9999 ", "A000 ", "A001 " },
      { "9998 ", "9999 ", "   0 ", "   1 " }, { "9998 ", "9999 ", "**** ", "**** " } })
  {
    const Macromolecule molecule = FromPDB(WaterLines(file));
    EXPECT_EQ(CollectResidueNumbers(molecule), five) << file[2];
    for (const Atom& atom : molecule.Atoms)
    {
      EXPECT_EQ(atom.InsertionCode, ' ') << file[2];
    }
    EXPECT_TRUE(Mention(molecule.Notes, "Residues w")) << file[2];
  }
  // Five digits in 22-26, where the chain would be.
  std::string wide = WaterLines({ "9998 ", "9999 " });
  wide += WaterLines({ "0000 ", "0001 " }, "SOL 1");
  const Macromolecule molecule = FromPDB(wide);
  EXPECT_EQ(CollectResidueNumbers(molecule), five);
  EXPECT_EQ(molecule.Atoms.back().Chain, "");
  // All numbers one column to the right, as "%5d" writes them.
  EXPECT_EQ(CollectResidueNumbers(FromPDB(WaterLines({ "    7", "  120", " 9999", "10000" }))),
    (std::vector<int>{ 7, 7, 120, 120, 9999, 9999, 10000, 10000 }));
  // Letters in hexadecimal numbers.
  EXPECT_EQ(CollectResidueNumbers(FromPDB(WaterLines({ "2719 ", "271a ", "271b " }))),
    (std::vector<int>{ 2719, 2719, 10010, 10010, 10011, 10011 }));
}

TEST(PDBColumns, NumbersAreTakenLiterally)
{
  // Insertion codes are letters; a chain may begin with 0; the numbering does not continue into
  // another chain.
  const Macromolecule codes =
    FromPDB(AtomLine("1", " CA", "ALA A  52 ", 0) + AtomLine("2", " CA", "ALA A  52A", 4) +
      AtomLine("3", " CA", "ALA A9999 ", 8) + AtomLine("4", " CA", "ALA B   0 ", 12) +
      AtomLine("5", " CA", "ALA B  -1 ", 16) + AtomLine("6", " CA", "ALA 11000 ", 20));
  EXPECT_EQ(Descriptions(codes),
    "CA of ALA 52 A, CA of ALA 52A A, CA of ALA 9999 A, CA of ALA 0 B, CA of ALA -1 B, "
    "CA of ALA 1000 1");
}

TEST(PDBColumns, NumbersInBases)
{
  EXPECT_EQ(PDBNumber("A000", 36), 10000);
  EXPECT_EQ(PDBNumber("ZZZZ", 36), 1223055);
  EXPECT_EQ(PDBNumber("a000", 36), 1223056);
  EXPECT_EQ(PDBNumber("A0000", 36), 100000);
  EXPECT_EQ(PDBNumber("a0000", 36), 43770016);
  EXPECT_EQ(PDBNumber("186a0", 16), 100000);
  EXPECT_EQ(PDBNumber("9999", 36), std::nullopt); // decimal
  EXPECT_EQ(PDBNumber("A 00", 36), std::nullopt);
  EXPECT_EQ(PDBNumber("", 16), std::nullopt);
}

TEST(PDBColumns, SerialsInConect)
{
  const auto bonds = [](const std::vector<std::string>& serials, const std::string& conect)
  {
    std::string text;
    double x = 0.0;
    for (const std::string& serial : serials)
    {
      text += AtomLine(serial, " C1", "LIG A   1 ", x += 10.0, 0, 0, "  1.00  0.00           C");
    }
    std::string found;
    for (const Bond& bond : FromPDB(text + conect).Bonds)
    {
      found += std::to_string(bond.First) + "-" + std::to_string(bond.Second) + " ";
    }
    return found;
  };
  // VMD, cctbx, asterisks (numbering continues), six digits (PyMOL, OpenMM).
  EXPECT_EQ(bonds({ "99998", "99999", "186a0", "186a1" }, "CONECT186a0186a199999\n"), "1-2 2-3 ");
  EXPECT_EQ(bonds({ "99998", "99999", "A0000", "A0001" }, "CONECTA0000A000199999\n"), "1-2 2-3 ");
  EXPECT_EQ(bonds({ "99998", "99999", "*****", "*****" }, "CONECT9999899999\n"), "0-1 ");
  EXPECT_EQ(
    FromPDB("HETATM100000FE   HEM A   1       1.000   0.000   0.000  1.00  0.00          FE\n"
            "HETATM100001 NA  HEM A   1       9.000   0.000   0.000  1.00  0.00           N\n"
            "CONECT100000100001\n")
      .Bonds.size(),
    1u);
  // Digits that mean one atom in base 10 and another in base 16.
  const Macromolecule both = FromPDB(AtomLine("18700", " C1", "LIG A   1 ", 0) +
    AtomLine("186ff", " C2", "LIG A   1 ", 10) + AtomLine("18700", " C3", "LIG A   1 ", 20) +
    AtomLine("18701", " C4", "LIG A   1 ", 30) + "CONECT186ff18701\nCONECT18700186ff\n");
  EXPECT_EQ(both.Bonds.size(), 1u);
  EXPECT_TRUE(Mention(both.Notes, "with ambiguous serial numbers"));
}

TEST(PDBColumns, CoordinatesWiderThanTheirColumns)
{
  // C's %8.3f moves all that follows; Fortran's F8.3 writes asterisks.
  const std::string text =
    "ATOM      1  CA  ALA A   1   -1234.567   1.000   2.000  1.00 20.00      PROT C\n"
    "ATOM      2  CA  ALA A   2      10.00010000.125-2000.250  0.50 30.00      PROT C\n"
    "ATOM      3  CA  ALA A   3      14.000   0.000   0.000  1.00 40.00      PROT C\n";
  const std::string first =
    "ATOM      1  CA  ALA A   1    -1234.567   1.000   2.000  1.00 20.00      PROT C\n";
  const Macromolecule molecule = FromPDB(first + text.substr(text.find('\n') + 1));
  ASSERT_EQ(molecule.Atoms.size(), 3u);
  EXPECT_EQ(molecule.Atoms[0].Position, (std::array<double, 3>{ -1234.567, 1.0, 2.0 }));
  EXPECT_EQ(molecule.Atoms[1].Position, (std::array<double, 3>{ 10.0, 10000.125, -2000.25 }));
  EXPECT_EQ(molecule.Atoms[1].Occupancy, 0.5);
  EXPECT_EQ(molecule.Atoms[1].BFactor, 30.0);
  EXPECT_EQ(JoinElements(molecule), "C C C ");
  EXPECT_TRUE(Mention(molecule.Notes, "wider than their columns, which shift what follows: 2."));
  // Without a chain, the segment is found at its shifted position.
  const Macromolecule segment =
    FromPDB("ATOM      1  CA  ALA     1    -1234.567   1.000   2.000  1.00 20.00      PROT C\n");
  EXPECT_EQ(Descriptions(segment), "CA of ALA 1 PROT");

  const Macromolecule lost =
    FromPDB("ATOM      1  CA  ALA A   1    ********   1.000   2.000  1.00 20.00           C\n" +
      AtomLine("2", " CA", "ALA A   2 ", 4) + AtomLine("3", " CB", "ALA A   2 ", 5.5));
  EXPECT_EQ(Descriptions(lost), "CA of ALA 2 A, CB of ALA 2 A");
  EXPECT_TRUE(Mention(lost.Warnings, "Atoms with asterisks for coordinates, dropped: 1"));
  EXPECT_TRUE(Mention(lost.Warnings, "line 1"));
}

TEST(PDBColumns, SegmentsReplaceMissingChains)
{
  const auto line = [](const char* chain, const char* segment)
  {
    return AtomLine("1", " CA", std::string("ALA ") + chain + "   1 ", 0, 0, 0,
      std::string("  1.00  0.00      ") + segment + " C");
  };
  EXPECT_EQ(FromPDB(line(" ", "PROA")).Atoms[0].Chain, "PROA");
  EXPECT_EQ(FromPDB(line("B", "PROA")).Atoms[0].Chain, "B");
  EXPECT_EQ(FromPDB(line(" ", "    ")).Atoms[0].Chain, "");
  EXPECT_EQ(FromPDB(line(" ", "A   ")).Atoms[0].Chain, "A");
  MoleculeOptions options;
  options.Chains = "PROB";
  EXPECT_EQ(
    ParseMolecule(line(" ", "PROA") + line(" ", "PROB"), MoleculeFormat::PDB, options).Atoms.size(),
    1u);
}

// ------------------------------------------------------------------------------------------
// Records that cannot be read

TEST(PDBRecords, ReportedFile)
{
  EXPECT_EQ(FromReport("vermouth_tests_data_2dn2.pdb.gz").Atoms.size(), 4384u);
}

TEST(PDBRecords, StrayRecordsDropNoAtoms)
{
  std::vector<std::string> lines;
  for (int i = 1; i <= 4; ++i)
  {
    lines.push_back(AtomLine(std::to_string(i), i % 2 == 1 ? " N" : " CA",
      "ALA A   " + std::to_string(i) + " ", 9.0 * i, 0, 0, "  1.00 10.00           C"));
  }
  lines.push_back("TER\n");
  lines.push_back("END\n");
  for (const std::string stray :
    { "ANISOU    9  CA  ALA A   9     2406   1892   1614    198    519   -328       C\n",
      "ANISOU bad\n", "CONECT\n", "CONECT one two\n", "CONECT    1 <--> 2\n", "CONECT 1.5 x\n",
      "TER   what is this\n", "TER\nTER\n", "REMARK 350\n", "REMARK 350   BIOMT1   x\n", "REMARK\n",
      "SSBOND\n", "SSBOND   1 CYS\n", "LINK\n", "LINKR\n", "CRYST1 no cell\n", "HELIX\n",
      "SHEET 1\n", "SEQRES\n", "SCALE1 x\n", "MTRIX1 x\n", "ORIGX9\n", "HEADER\n", "DBREF2\n",
      "MASTER x\n", "\n", "\0\n", "USER  MOD\n", "SIGATM    1\n", "MODRES\n", "JRNL\n", "HET\n",
      "data\n" })
  {
    for (std::size_t at = 0; at < lines.size(); ++at)
    {
      std::string text;
      for (std::size_t i = 0; i < lines.size(); ++i)
      {
        text += (i == at ? stray : "") + lines[i];
      }
      const Macromolecule molecule = FromPDB(text);
      ASSERT_EQ(Descriptions(molecule), "N of ALA 1 A, CA of ALA 2 A, N of ALA 3 A, CA of ALA 4 A")
        << stray << " before line " << at;
      const bool isConect = stray.substr(0, 6) == "CONECT";
      EXPECT_EQ(Mention(molecule.Warnings, "CONECT records"), isConect) << stray;
    }
  }
}

TEST(PDBRecords, DroppedRecordsAreCounted)
{
  const std::string atoms = AtomLine("1", " N", "ALA A   1 ", 0, 0, 0, "  1.00 10.00           N") +
    AtomLine("2", " CA", "ALA A   1 ", 4, 0, 0, "  1.00 10.00           C") +
    AtomLine("3", " C", "ALA A   1 ", 8, 0, 0, "  x.xx 10.00           C") +
    AtomLine("4", " O", "ALA A   1 ", 12, 0, 0, "  1.00 10.00           Oxy");
  const Macromolecule molecule = FromPDB(atoms +
    "CONECT    1    2\nCONECT nonsense\nCONECT more of it\nCONECT    1    z\nCONECT    1   77\n");
  EXPECT_EQ(molecule.Atoms.size(), 4u);
  EXPECT_EQ(molecule.Bonds.size(), 1u);
  ASSERT_EQ(molecule.Warnings.size(), 1u) << "one warning for all";
  for (const char* words : { "Unreadable CONECT records, dropped: 2 (first: line 6)",
         "Fields of CONECT records that are not serial numbers, dropped: 1",
         "Occupancies and B factors that are not numbers, dropped: 1 (first: line 3)",
         "Unreadable formal charges (columns 79-80), dropped: 1 (first: line 4)" })
  {
    EXPECT_TRUE(Mention(molecule.Warnings, words)) << words << "\n" << molecule.Warnings[0];
    EXPECT_TRUE(Mention(molecule.Notes, words)) << words;
  }
  EXPECT_TRUE(Mention(
    molecule.Notes, "Bonds of CONECT records with atoms that are not in this model, dropped: 1."));
  EXPECT_TRUE(std::isnan(molecule.Atoms[2].Occupancy));
  EXPECT_EQ(molecule.Atoms[3].Element, 8);
}

TEST(PDBRecords, ReportsSumEqualCounts)
{
  ReadingReport report;
  report.Count("Lines, dropped", "line 2");
  report.Count("Lines, dropped", "line 9", 3);
  report.Count("nothing", "", 0);
  report.Note("For reference.");
  report.Warn("Look here.");
  Macromolecule molecule;
  report.AddTo(molecule);
  EXPECT_EQ(
    molecule.Warnings, std::vector<std::string>{ "Look here. Lines, dropped: 4 (first: line 2)." });
  EXPECT_EQ(molecule.Notes,
    (std::vector<std::string>{
      "For reference.", "Look here.", "Lines, dropped: 4 (first: line 2)." }));
  Macromolecule nothing;
  ReadingReport().AddTo(nothing);
  EXPECT_TRUE(nothing.Notes.empty() && nothing.Warnings.empty());
}

}

// Some programs number all residues 1: a residue that comes again is no copy of the chain.
TEST(PDBFile, ResiduesOfOneNumberAreOneChain)
{
  std::string text;
  for (const char* name : { "LEU", "GLY", "LEU", "ALA", "GLY" })
  {
    const std::string residue = std::string(name) + " X   1 ";
    text += AtomLine("1", " N", residue, 0) + AtomLine("2", " CA", residue, 1.5);
  }
  const Macromolecule molecule = FromPDB(text);
  ASSERT_EQ(molecule.Atoms.size(), 10u);
  for (const Atom& atom : molecule.Atoms)
  {
    EXPECT_EQ(atom.Chain, "X");
  }
}
