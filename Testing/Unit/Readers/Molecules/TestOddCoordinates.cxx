// Coordinates in another unit, and molecules broken at a periodic box; biological units, whose
// copies are models; residue names that PDB files shorten.

#include "Molecules/PeriodicMolecules.h"
#include "PDBText.h"
#include "TemporaryFile.h"
#include "vtkMacromoleculeReader.h"

#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

using Place = std::array<double, 3>;

/// The places of a strand: N, CA, C and CB of residues along x, all bonded to the next, 1.45 apart.
std::vector<Place> Strand(int residues)
{
  std::vector<Place> places;
  for (int i = 0; i < residues; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int n = 3 * i + k;
      places.push_back({ 1.2 * n, n % 2 == 0 ? 0.0 : 0.8, 0.0 });
    }
    places.push_back({ 1.2 * (3 * i + 1), i % 2 == 0 ? 2.3 : -1.5, 0.3 });
  }
  return places;
}

/// Alanines at places, in columns of PDB.
std::string Alanines(
  const std::vector<Place>& places, char chain = 'A', int firstSerial = 1, double scale = 1.0)
{
  const char* const names[] = { " N", " CA", " C", " CB" };
  std::string text;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::array<char, 32> residue;
    std::snprintf(residue.data(), residue.size(), "ALA %c%4d ", chain, static_cast<int>(i / 4) + 1);
    text += AtomLine(std::to_string(firstSerial + static_cast<int>(i)), names[i % 4],
      residue.data(), scale * places[i][0], scale * places[i][1], scale * places[i][2],
      std::string("  1.00 10.00           ") + names[i % 4][1]);
  }
  return text;
}

std::vector<Place> Moved(std::vector<Place> places, const Place& by)
{
  for (Place& place : places)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      place[k] += by[k];
    }
  }
  return places;
}

std::vector<Place> Turned(std::vector<Place> places)
{
  for (Place& place : places)
  {
    place = { -place[1], place[0], place[2] };
  }
  return places;
}

std::string Model(int number, const std::string& atoms)
{
  return "MODEL     " + std::string(number < 10 ? "   " : "  ") + std::to_string(number) + "\n" +
    atoms + "TER\nENDMDL\n";
}

std::set<std::string> ChainsOf(const Macromolecule& molecule)
{
  std::set<std::string> chains;
  for (const Atom& atom : molecule.Atoms)
  {
    chains.insert(atom.Chain);
  }
  return chains;
}

MoleculeOptions Options(ModelCombination combine, CoordinateUnit unit = CoordinateUnit::ByFormat)
{
  MoleculeOptions options;
  options.CombineModels = combine;
  options.LengthUnit = unit;
  return options;
}

Macromolecule FromReport(const std::string& name, const MoleculeOptions& options)
{
  return ReadMacromolecule((SharedDataFolder() / "reports" / name).string(), options);
}

double LongestBond(const Macromolecule& molecule)
{
  double longest = 0.0;
  for (const Bond& bond : molecule.Bonds)
  {
    const Place& a = molecule.Atoms[static_cast<std::size_t>(bond.First)].Position;
    const Place& b = molecule.Atoms[static_cast<std::size_t>(bond.Second)].Position;
    longest = std::max(longest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  return longest;
}

/// Each place in the cell, as simulation programs write atoms.
std::vector<Place> Wrapped(std::vector<Place> places, double box)
{
  for (Place& place : places)
  {
    for (double& x : place)
    {
      x -= box * std::floor(x / box);
    }
  }
  return places;
}

/// A GRO file of alanines, nm; `box` is its last line.
std::string GROText(const std::vector<Place>& places, const std::string& box, double scale = 0.1)
{
  std::string text = "title\n" + std::to_string(places.size()) + "\n";
  const char* const names[] = { "N", "CA", "C", "CB" };
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    std::array<char, 100> line;
    std::snprintf(line.data(), line.size(), "%5d%-5s%5s%5d%8.3f%8.3f%8.3f\n",
      static_cast<int>(i / 4) + 1, "ALA", names[i % 4], static_cast<int>(i) + 1,
      scale * places[i][0], scale * places[i][1], scale * places[i][2]);
    text += line.data();
  }
  return text + box + "\n";
}

constexpr const char* Cubic = "CRYST1   30.000   30.000   30.000  90.00  90.00  90.00 P 1\n";

/// Distances from the first atom are those of `whole`.
void ExpectShape(const Macromolecule& molecule, const std::vector<Place>& whole, double tolerance)
{
  ASSERT_EQ(molecule.Atoms.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(molecule.Atoms[i].Position[k] - molecule.Atoms[0].Position[k],
        whole[i][k] - whole[0][k], tolerance)
        << i;
    }
  }
}

}

// ------------------------------------------------------------------------------------------
// Biological units

TEST(BiologicalUnits, ReportedFiles)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/g03_biounit.pdb");
  const Macromolecule unit = FromReport("g03_biounit.pdb", MoleculeOptions());
  EXPECT_EQ(unit.Atoms.size(), 120u);
  EXPECT_EQ(unit.NumberOfModels, 1);
  EXPECT_EQ(ChainsOf(unit).size(), 2u);
  EXPECT_TRUE(Mention(unit.Notes, "set CombineModels to Never"));
  EXPECT_TRUE(unit.Warnings.empty());
  const Macromolecule frames = FromReport("g03_biounit.pdb", Options(ModelCombination::Never));
  EXPECT_EQ(frames.Atoms.size(), 60u);
  EXPECT_EQ(frames.NumberOfModels, 2);
  const Macromolecule ensemble = FromReport("g03c_nmr.pdb", MoleculeOptions());
  EXPECT_EQ(ensemble.Atoms.size(), 60u);
  EXPECT_EQ(ensemble.NumberOfModels, 2);
  EXPECT_EQ(FromReport("g03c_nmr.pdb", Options(ModelCombination::Always)).Atoms.size(), 120u);
}

TEST(BiologicalUnits, CopiesBesideEachOtherAreOneStructure)
{
  const std::vector<Place> one = Strand(6);
  const std::string first = Model(1, Alanines(one));
  // Turned and moved, several times, in contact; another chain as the second model.
  const std::string turned = Model(2, Alanines(Moved(Turned(one), { 0, 30, 0 })));
  const std::string third = Model(3, Alanines(Moved(one, { 0, 0, 4 })));
  EXPECT_EQ(FromPDB(first + turned).Atoms.size(), 48u);
  const Macromolecule three = FromPDB(first + turned + third);
  EXPECT_EQ(three.Atoms.size(), 72u);
  EXPECT_EQ(ChainsOf(three).size(), 3u);
  const std::string other = Model(2, Alanines(Moved(Strand(5), { 0, 10, 0 }), 'B'));
  EXPECT_EQ(ChainsOf(FromPDB(first + other)), (std::set<std::string>{ "A", "B" }));
  // CONECT and SSBOND name the atoms of each copy.
  const std::string conect = "CONECT    4    8\n";
  std::size_t named = 0;
  for (const Bond& bond : FromPDB(first + turned + third + conect).Bonds)
  {
    named += bond.FromFile ? 1 : 0;
    EXPECT_TRUE(!bond.FromFile || bond.Second - bond.First == 4) << bond.First;
  }
  EXPECT_EQ(named, 3u);
}

TEST(BiologicalUnits, OverlappingOrDifferentModelsAreFrames)
{
  const std::vector<Place> one = Strand(6);
  const std::string first = Model(1, Alanines(one));
  const auto models = [&](const std::string& others)
  { return FromPDB(first + others).NumberOfModels; };
  EXPECT_EQ(models(Model(2, Alanines(Moved(one, { 1, 0, 0 })))), 2);
  EXPECT_EQ(models(Model(2, Alanines(Moved(one, { 0, 0, 50 }))) +
              Model(3, Alanines(Moved(one, { 0.5, 0, 0 })))),
    3);
  // A molecule that moves far away changes its shape meanwhile.
  std::vector<Place> bent = Moved(one, { 0, 0, 50 });
  for (std::size_t i = bent.size() / 2; i < bent.size(); ++i)
  {
    bent[i][2] += 0.5 * static_cast<double>(i - bent.size() / 2);
  }
  EXPECT_EQ(models(Model(2, Alanines(bent))), 2);
  // One chain with other atoms.
  EXPECT_EQ(models(Model(2, Alanines(Moved(Strand(7), { 0, 0, 50 })))), 2);
  // Poses of a ligand at several places of a receptor.
  const std::string pose =
    AtomLine("1", " C1", "LIG A   1 ", 0) + AtomLine("2", " C2", "LIG A   1 ", 1.5);
  const std::string far =
    AtomLine("1", " C1", "LIG A   1 ", 30) + AtomLine("2", " C2", "LIG A   1 ", 31.5);
  EXPECT_EQ(FromPDB(Model(1, pose) + Model(2, far)).NumberOfModels, 2);
}

TEST(BiologicalUnits, AreCountedAndNamedAsTheyAreRead)
{
  const std::vector<Place> one = Strand(6);
  const std::string two = Model(1, Alanines(one)) + Model(2, Alanines(Moved(one, { 0, 20, 0 })));
  const std::string threeFrames = two + Model(3, Alanines(Moved(one, { 0.5, 0, 0 })));
  for (const char* name : { "a.pdb1", "a.pdb9", "a.PDB2", "a.pdb" })
  {
    const TemporaryFile plain(two, name);
    const TemporaryFile frames(threeFrames, name);
    const TemporaryFile packed(Gzip(two), std::string(name) + ".gz");
    EXPECT_EQ(CountModels(plain.Path(), MoleculeFormat::ByName), 1);
    EXPECT_EQ(CountModels(packed.Path(), MoleculeFormat::ByName), 1);
    EXPECT_EQ(CountModels(frames.Path(), MoleculeFormat::ByName), 3);
    EXPECT_EQ(
      CountModels(plain.Path(), MoleculeFormat::ByName, nullptr, ModelCombination::Never), 2);
    EXPECT_EQ(ReadMacromolecule(plain.Path(), MoleculeOptions()).Atoms.size(), 48u);
    EXPECT_TRUE(vtkMacromoleculeReader::CanReadFile(plain.Path()));
    vtkNew<vtkMacromoleculeReader> reader;
    reader->SetFileName(plain.Path());
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 48);
    reader->SetCombineModels(vtkMacromoleculeReader::Never);
    reader->Update();
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 24);
    EXPECT_EQ(
      reader->GetOutputInformation(0)->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 2);
  }
  const TemporaryFile other(two, "a.pdb0");
  EXPECT_FALSE(vtkMacromoleculeReader::CanReadFile(other.Path()));
}

// ------------------------------------------------------------------------------------------
// Shortened residue names

TEST(ShortenedNames, ReportedFile)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/g04c_tilde.pdb");
  const Macromolecule molecule = isthmus::testing::FromReport("g04c_tilde.pdb");
  std::size_t count = 0;
  for (const Atom& atom : molecule.Atoms)
  {
    EXPECT_NE(atom.ResidueName[0], '~');
    count += atom.ResidueName == "A1LU6" ? 1 : 0;
  }
  EXPECT_GT(count, 0u);
}

TEST(ShortenedNames, AreThoseOfHETNAM)
{
  // As gemmi writes it: a description, and the name in columns 72-79.
  std::string gemmi = "HETNAM     ~A1 4-(2-METHYLPHENYL) BENZOIC ACID";
  gemmi.resize(71, ' ');
  gemmi += "A1ABC\n";
  const std::string atoms =
    AtomLine("1", " C1", "~A1 A   1 ", 0, 0, 0, "  1.00  0.00           C", true) +
    AtomLine("2", " C1", "~B2 A   2 ", 9, 0, 0, "  1.00  0.00           C", true) +
    AtomLine("3", " CA", "ALA A   3 ", 18, 0, 0, "  1.00  0.00           C");
  const Macromolecule both = FromPDB(
    "HETNAM     ~B2 A1XYZ                                               \n" + gemmi + atoms);
  EXPECT_EQ(both.Atoms[0].ResidueName, "A1ABC");
  EXPECT_EQ(both.Atoms[1].ResidueName, "A1XYZ");
  EXPECT_EQ(both.Atoms[2].ResidueName, "ALA");
  EXPECT_TRUE(Mention(both.Notes, "~A1 is A1ABC, ~B2 is A1XYZ"));
  const Macromolecule one = FromPDB(gemmi + atoms);
  EXPECT_EQ(one.Atoms[1].ResidueName, "~B2");
  EXPECT_TRUE(Mention(one.Notes, "does not give (HETNAM): ~B2."));
  EXPECT_TRUE(one.Warnings.empty());
}

// ------------------------------------------------------------------------------------------
// Units of length

TEST(LengthUnits, ReportedFile)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/i04_nm.pdb");
  const Macromolecule molecule = isthmus::testing::FromReport("i04_nm.pdb");
  ASSERT_EQ(molecule.Warnings.size(), 1u);
  EXPECT_TRUE(Mention(molecule.Warnings, "set LengthUnit to Nanometre")) << molecule.Warnings[0];
  EXPECT_TRUE(Mention(molecule.Warnings, "angstrom away")) << molecule.Warnings[0];
  EXPECT_TRUE(molecule.Bonds.empty());
  const Macromolecule right =
    FromReport("i04_nm.pdb", Options(ModelCombination::Automatic, CoordinateUnit::Nanometre));
  EXPECT_TRUE(right.Warnings.empty());
  EXPECT_NEAR(right.Atoms[0].Position[1], 9.98, 1e-9);
  EXPECT_GT(right.Bonds.size(), right.Atoms.size() - 50);
  EXPECT_LT(right.Bonds.size(), right.Atoms.size() + 100);
}

TEST(LengthUnits, OfEachFormat)
{
  const std::vector<Place> places = Strand(8);
  const auto warned = [](const Macromolecule& molecule, const char* words)
  { return Mention(molecule.Warnings, words); };
  // Nanometre in PDB, also with C-alphas alone.
  const Macromolecule small = FromPDB(Alanines(places, 'A', 1, 0.1));
  EXPECT_TRUE(warned(small, "set LengthUnit to Nanometre"));
  std::string alphas;
  for (int i = 0; i < 12; ++i)
  {
    std::array<char, 16> residue;
    std::snprintf(residue.data(), residue.size(), "GLY A%4d ", i + 1);
    alphas += AtomLine(std::to_string(i + 1), " CA", residue.data(), 0.38 * i);
  }
  EXPECT_TRUE(warned(FromPDB(alphas), "set LengthUnit to Nanometre"));
  // Angstrom in GRO.
  const std::string gro = GROText(places, "30 30 30", 1.0);
  const Macromolecule large = ParseMolecule(gro, MoleculeFormat::GRO);
  EXPECT_TRUE(warned(large, "set LengthUnit to Angstrom"));
  const Macromolecule right = ParseMolecule(
    gro, MoleculeFormat::GRO, Options(ModelCombination::Automatic, CoordinateUnit::Angstrom));
  EXPECT_TRUE(right.Warnings.empty()) << right.Warnings[0];
  EXPECT_NEAR(right.Atoms[1].Position[0], 1.2, 1e-6);
  EXPECT_NEAR(right.Cell[2][2], 30.0, 1e-9);
  // XYZ in bohr, only on request.
  std::string xyz = "12\n\n";
  for (int i = 0; i < 12; ++i)
  {
    xyz += "C " + std::to_string(2.6 * i) + " 0 0\n";
  }
  const Macromolecule bohr = ParseMolecule(
    xyz, MoleculeFormat::XYZ, Options(ModelCombination::Automatic, CoordinateUnit::Bohr));
  EXPECT_NEAR(bohr.Atoms[1].Position[0], 2.6 * 0.529177, 1e-4);
  EXPECT_EQ(bohr.Bonds.size(), 11u);
  EXPECT_TRUE(bohr.Warnings.empty());
}

TEST(LengthUnits, SoundFilesAreNotWarnedOf)
{
  const std::vector<Place> places = Strand(8);
  EXPECT_TRUE(FromPDB(Alanines(places)).Warnings.empty());
  EXPECT_TRUE(ParseMolecule(GROText(places, "30 30 30"), MoleculeFormat::GRO).Warnings.empty());
  // Twice the same molecule, which is not a matter of units; ions far from each other.
  const Macromolecule twice =
    FromPDB(Alanines(places) + "END\n" + Alanines(Moved(places, { 0.1, 0, 0 }), 'B'));
  EXPECT_FALSE(Mention(twice.Warnings, "unit"));
  std::string ions;
  for (int i = 0; i < 12; ++i)
  {
    std::array<char, 16> residue;
    std::snprintf(residue.data(), residue.size(), " CL A%4d ", i + 1);
    ions += AtomLine(std::to_string(i + 1), "CL", residue.data(), 12.0 * i, 0, 0,
      "  1.00  0.00          CL", true);
  }
  EXPECT_FALSE(Mention(FromPDB(ions).Warnings, "unit"));
}

// ------------------------------------------------------------------------------------------
// Periodic boxes

TEST(PeriodicBoxes, ReportedFiles)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/m01_wrapped.gro");
  const Macromolecule whole = isthmus::testing::FromReport("m01c_whole.gro");
  const Macromolecule wrapped = isthmus::testing::FromReport("m01_wrapped.gro");
  EXPECT_EQ(wrapped.Bonds.size(), whole.Bonds.size());
  EXPECT_LT(LongestBond(wrapped), 2.0);
  EXPECT_TRUE(Mention(wrapped.Notes, "Molecules broken at the periodic box"));
  EXPECT_FALSE(Mention(whole.Notes, "periodic box"));
  EXPECT_TRUE(wrapped.Warnings.empty());
  // Both chains are beside each other as in the whole file.
  ASSERT_EQ(wrapped.Atoms.size(), whole.Atoms.size());
  for (std::size_t i = 0; i < whole.Atoms.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(wrapped.Atoms[i].Position[k] - wrapped.Atoms[0].Position[k],
        whole.Atoms[i].Position[k] - whole.Atoms[0].Position[k], 0.03)
        << i;
    }
  }
}

TEST(PeriodicBoxes, MoleculesAreMadeWhole)
{
  const std::vector<Place> whole = Moved(Strand(7), { 17, 29.5, 0.1 });
  const std::vector<Place> wrapped = Wrapped(whole, 30.0);
  const Macromolecule pdb = FromPDB(Cubic + Alanines(wrapped));
  ExpectShape(pdb, whole, 0.002);
  EXPECT_TRUE(Mention(pdb.Notes, "made whole by the cell of the file: 1"));
  EXPECT_TRUE(pdb.Warnings.empty());
  EXPECT_EQ(pdb.Bonds.size(), FromPDB(Alanines(whole)).Bonds.size());
  ExpectShape(ParseMolecule(GROText(wrapped, "3 3 3"), MoleculeFormat::GRO), whole, 0.02);
  // By residues, as some programs wrap.
  std::vector<Place> byResidue = whole;
  for (std::size_t i = 0; i < whole.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      byResidue[i][k] -= 30.0 * std::floor(whole[i / 4 * 4][k] / 30.0);
    }
  }
  ExpectShape(FromPDB(Cubic + Alanines(byResidue)), whole, 0.002);
  // Without bonds by distance, too.
  MoleculeOptions none;
  none.BondsByDistance = false;
  const Macromolecule bare = ParseMolecule(Cubic + Alanines(wrapped), MoleculeFormat::PDB, none);
  ExpectShape(bare, whole, 0.002);
  EXPECT_TRUE(bare.Bonds.empty());
  // Extended XYZ.
  std::string xyz = std::to_string(wrapped.size()) +
    "\nLattice=\"30 0 0 0 30 0 0 0 30\" Properties=species:S:1:pos:R:3\n";
  for (const Place& place : wrapped)
  {
    xyz += "C " + std::to_string(place[0]) + " " + std::to_string(place[1]) + " " +
      std::to_string(place[2]) + "\n";
  }
  ExpectShape(ParseMolecule(xyz, MoleculeFormat::XYZ), whole, 1e-4);
}

TEST(PeriodicBoxes, TriclinicCells)
{
  const std::vector<Place> cell = CellVectors({ 30, 30, 30 }, { 60, 60, 90 });
  ASSERT_EQ(cell.size(), 3u);
  EXPECT_NEAR(cell[2][0], 15.0, 1e-9);
  EXPECT_NEAR(cell[2][1], 15.0, 1e-9);
  EXPECT_NEAR(cell[2][2], 30.0 * std::sqrt(0.5), 1e-9);
  const std::vector<Place> whole = Strand(7);
  std::vector<Place> wrapped = whole;
  for (std::size_t i = 10; i < wrapped.size(); ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      wrapped[i][k] += cell[2][k] - cell[0][k];
    }
  }
  ExpectShape(
    FromPDB("CRYST1   30.000   30.000   30.000  60.00  60.00  90.00 P 1\n" + Alanines(wrapped)),
    whole, 0.002);
  ExpectShape(
    ParseMolecule(GROText(wrapped, "3.0 3.0 2.12132 0 0 0 0 1.5 1.5"), MoleculeFormat::GRO), whole,
    0.02);
}

TEST(PeriodicBoxes, ChainsAreMovedToEachOther)
{
  // Two strands 4 angstrom apart, on both sides of the face z = 0.
  const std::vector<Place> one = Moved(Strand(7), { 17, 15, 1 });
  const std::vector<Place> two = Moved(Strand(6), { 2, 15, 27 });
  const Macromolecule molecule =
    FromPDB(Cubic + Alanines(Wrapped(one, 30.0)) + Alanines(two, 'B', 100));
  ASSERT_EQ(molecule.Atoms.size(), one.size() + two.size());
  EXPECT_NEAR(molecule.Atoms.back().Position[2] - molecule.Atoms[0].Position[2],
    two.back()[2] - 30.0 - one[0][2], 0.01);
  EXPECT_TRUE(Mention(molecule.Notes, "to those they touch: 1")) << molecule.Notes.back();
}

TEST(PeriodicBoxes, EachFrameHasItsOwn)
{
  const std::vector<Place> whole = Moved(Strand(7), { 17, 15, 15 });
  const std::string larger = "CRYST1   34.000   34.000   34.000  90.00  90.00  90.00 P 1\n";
  const std::string text = Cubic + Model(1, Alanines(Wrapped(whole, 30.0))) + larger +
    Model(2, Alanines(Wrapped(whole, 34.0)));
  ExpectShape(FromPDB(text, 0), whole, 0.002);
  ExpectShape(FromPDB(text, 1), whole, 0.002);
  const std::string gro =
    GROText(Wrapped(whole, 30.0), "3 3 3") + GROText(Wrapped(whole, 34.0), "3.4 3.4 3.4");
  for (const std::int64_t frame : { 0, 1 })
  {
    MoleculeOptions options;
    options.ModelIndex = frame;
    ExpectShape(ParseMolecule(gro, MoleculeFormat::GRO, options), whole, 0.02);
  }
}

TEST(PeriodicBoxes, WithoutACellThereIsAWarning)
{
  const std::vector<Place> whole = Moved(Strand(7), { 17, 15, 15 });
  std::vector<Place> wrapped = Wrapped(whole, 30.0);
  const Macromolecule torn = FromPDB(Alanines(wrapped));
  ASSERT_EQ(torn.Warnings.size(), 1u);
  EXPECT_TRUE(Mention(torn.Warnings, "torn apart")) << torn.Warnings[0];
  EXPECT_TRUE(Mention(torn.Warnings, "has no cell")) << torn.Warnings[0];
  // Between residues; a cell that does not fit.
  std::vector<Place> byResidue = whole;
  for (std::size_t i = 12; i < whole.size(); ++i)
  {
    byResidue[i][0] -= 30.0;
  }
  EXPECT_TRUE(Mention(FromPDB(Alanines(byResidue)).Warnings, "C of ALA 3 A and N of ALA 4 A"));
  EXPECT_TRUE(Mention(
    FromPDB("CRYST1   50.000   50.000   50.000  90.00  90.00  90.00 P 1\n" + Alanines(wrapped))
      .Warnings,
    "does not join them"));
  // A gap in a chain, and the dummy cell of NMR, are no reason.
  std::vector<Place> gap = whole;
  for (std::size_t i = 12; i < whole.size(); ++i)
  {
    gap[i][0] += 20.0;
    gap[i][1] += 7.0;
  }
  EXPECT_TRUE(
    FromPDB("CRYST1    1.000    1.000    1.000  90.00  90.00  90.00 P 1\n" + Alanines(gap))
      .Warnings.empty());
}

// A disulfide or a contact with a symmetry mate does not break a molecule; nor does an endless one.
TEST(PeriodicBoxes, CrystalsStayAsTheyAre)
{
  std::vector<Place> places = Strand(8); // 27.6 + 1.4 long: the ends meet across a cell of 29
  const std::string cell = "CRYST1   29.000   40.000   40.000  90.00  90.00  90.00 P 1\n";
  const Macromolecule molecule = FromPDB(cell + Alanines(places));
  ExpectShape(molecule, places, 0.002);
  EXPECT_FALSE(Mention(molecule.Notes, "box"));
  std::string tube = "3\nLattice=\"4.5 0 0 0 30 0 0 0 30\" Properties=species:S:1:pos:R:3\n";
  const Macromolecule chain =
    ParseMolecule(tube + "C 0 0 0\nC 1.5 0 0\nC 3 0 0\n", MoleculeFormat::XYZ);
  EXPECT_TRUE(Mention(chain.Notes, "bonded to their own images")) << chain.Notes.size();
  EXPECT_EQ(chain.Atoms[2].Position[0], 3.0);
  EXPECT_EQ(chain.Bonds.size(), 2u);
}
