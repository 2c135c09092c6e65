// Models and parts of PDB files: MODEL in any columns, END and ENDMDL between frames or molecules.

#include "PDBText.h"
#include "TemporaryFile.h"
#include "vtkMacromoleculeReader.h"

#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// A helix of `residues` with N, CA and C.
std::string Chain(
  char chain, double x, int residues = 10, const char* residue = "ALA", double phase = 0.0)
{
  std::string text;
  int serial = 0;
  for (int i = 1; i <= residues; ++i)
  {
    for (const char* name : { " N", " CA", " C" })
    {
      const double angle = 1.75 * i + phase;
      std::array<char, 32> columns;
      std::snprintf(columns.data(), columns.size(), "%s %c%4d ", residue, chain, i);
      const double shift = name[1] == 'N' ? -1.0 : (name[2] == 'A' ? 0.0 : 1.0);
      text += AtomLine(std::to_string(++serial), name, columns.data(), x + 2.3 * std::cos(angle),
        2.3 * std::sin(angle), 1.5 * i + shift, std::string("  1.00 10.00           ") + name[1]);
    }
  }
  return text;
}

/// The number of models, and atoms of the first and the last one, which must agree with CountModels
/// for the file, plain and compressed.
struct Reading
{
  explicit Reading(const std::string& text)
    : First(FromPDB(text))
  {
    const TemporaryFile plain(text, "models.pdb");
    const TemporaryFile compressed(Gzip(text), "models.pdb.gz");
    EXPECT_EQ(CountModels(plain.Path(), MoleculeFormat::ByName), this->First.NumberOfModels);
    EXPECT_EQ(CountModels(compressed.Path(), MoleculeFormat::ByName), this->First.NumberOfModels);
    this->Last = FromPDB(text, this->First.NumberOfModels - 1);
  }

  std::vector<std::size_t> Sizes() const
  {
    return { static_cast<std::size_t>(this->First.NumberOfModels), this->First.Atoms.size(),
      this->Last.Atoms.size() };
  }

  std::string Chains() const
  {
    std::string chains;
    for (const Atom& atom : this->First.Atoms)
    {
      chains += chains.empty() || chains.back() != atom.Chain[0] ? atom.Chain : "";
    }
    return chains;
  }

  Macromolecule First;
  Macromolecule Last;
};

using Sizes = std::vector<std::size_t>;

}

TEST(PDBModels, ReportedFiles)
{
  for (const auto& [name, models] :
    { std::pair("n01_end_separated_frames.pdb", 5), std::pair("n02_model_col7.pdb", 5) })
  {
    const Macromolecule last = FromReport(name, models - 1);
    EXPECT_EQ(last.NumberOfModels, models) << name;
    EXPECT_EQ(last.Atoms.size(), 3u) << name;
    EXPECT_EQ(last.Atoms[0].Position[0], 4.0) << name;
    EXPECT_EQ(
      CountModels((SharedDataFolder() / "reports" / name).string(), MoleculeFormat::PDB), models);
  }
  for (const char* name : { "n10_chains_repeat_after_end.pdb", "n14_clusplus_rec_lig.pdb" })
  {
    const Macromolecule molecule = FromReport(name);
    EXPECT_EQ(molecule.NumberOfModels, 1) << name;
    ASSERT_EQ(molecule.Atoms.size(), 6u) << name;
    EXPECT_EQ(molecule.Atoms[0].Chain, "A");
    EXPECT_EQ(molecule.Atoms[5].Chain, "B");
    EXPECT_TRUE(Mention(molecule.Notes, "read as one structure")) << name;
  }
}

TEST(PDBModels, ModelRecordsWithAnyNumbers)
{
  // wwPDB; Vina and other programs; elNemo's amplitudes; from 10000 on; none, and all the same.
  const std::string atoms[] = { Chain('A', 0), Chain('A', 1), Chain('A', 2) };
  for (const std::vector<std::string>& records :
    std::vector<std::vector<std::string>>{ { "MODEL        1", "MODEL        2", "MODEL        3" },
      { "MODEL 1", "MODEL 2", "MODEL 3" }, { "MODEL     -100", "MODEL        0", "MODEL      100" },
      { "MODEL     9999", "MODEL    10000", "MODEL   100001" }, { "MODEL", "MODEL", "MODEL" },
      { "MODEL        1", "MODEL        1", "MODEL        1" },
      { "MODEL  first", "MODEL  second", "MODEL  third" } })
  {
    for (const std::string end : { "ENDMDL\n", "", "TER\nENDMDL\nEND\n", "END\n" })
    {
      std::string text;
      for (std::size_t i = 0; i < 3; ++i)
      {
        text += records[i] + " \n" + atoms[i] + end;
      }
      const Reading reading(text);
      EXPECT_EQ(reading.Sizes(), (Sizes{ 3, 30, 30 })) << records[1] << end;
      EXPECT_EQ(reading.Last.Atoms[0].Position[0], reading.First.Atoms[0].Position[0] + 2.0);
    }
  }
}

TEST(PDBModels, OneModelRecordMayBeMissing)
{
  const std::string one = Chain('A', 0) + "ENDMDL\n";
  const std::string two = "MODEL        2\n" + Chain('A', 1) + "ENDMDL\n";
  EXPECT_EQ(FromPDB(one + two).NumberOfModels, 2);
  EXPECT_EQ(FromPDB(two + one + two + "END\n").NumberOfModels, 3);
  EXPECT_EQ(FromPDB(two + one, 1).Atoms.size(), 30u);
  EXPECT_FALSE(Mention(FromPDB(one + two).Warnings, "outside of MODEL"));
  const TemporaryFile file(one + two, "models.pdb");
  EXPECT_EQ(CountModels(file.Path(), MoleculeFormat::PDB), 2);
}

TEST(PDBModels, RecordsMayBeWrittenInSmallLetters)
{
  // Reading compares the count of the whole file with that of the reader.
  for (const std::string model : { "MODEL\n", "model 1\n", "Model\t1\n" })
  {
    for (const std::string end : { "endmdl\n", "end\n", "END\n" })
    {
      EXPECT_EQ(Reading(model + Chain('A', 0) + end + model + Chain('A', 1) + end).Sizes(),
        (Sizes{ 2, 30, 30 }))
        << model << end;
    }
  }
  std::string small = Chain('A', 0.5);
  for (std::size_t at = 0; at < small.size(); at = small.find('\n', at) + 1)
  {
    small.replace(at, 4, "atom");
  }
  EXPECT_EQ(Reading(Chain('A', 0) + "END\n" + small).Sizes(), (Sizes{ 2, 30, 30 }));
}

TEST(PDBModels, AtomsOutsideOfModelsJoinAnAdjacentModel)
{
  const std::string ligand =
    AtomLine("1", " C1", "LIG A 500 ", 3, 3, 3, "  1.00  0.00           C", true);
  const std::string model = "MODEL        1\n" + Chain('A', 0) + "ENDMDL\n";
  const Reading after(model + ligand + "END\n");
  EXPECT_EQ(after.Sizes(), (Sizes{ 1, 31, 31 }));
  EXPECT_TRUE(Mention(
    after.First.Warnings, "outside of MODEL and ENDMDL, read with the model beside them: 1."));
  EXPECT_EQ(Reading(ligand + model).Sizes(), (Sizes{ 1, 31, 31 }));
  EXPECT_EQ(Reading(model + model + ligand).Sizes(), (Sizes{ 2, 30, 31 }));
  // Models may differ, and may be empty: MODEL says that they are models.
  EXPECT_EQ(Reading(model + "MODEL        2\n" + Chain('B', 1, 4) + "ENDMDL\n").Sizes(),
    (Sizes{ 2, 30, 12 }));
}

TEST(PDBModels, FramesBetweenENDMDL)
{
  EXPECT_EQ(Reading(Chain('A', 0) + "ENDMDL\n" + Chain('A', 1) + "ENDMDL\n" + Chain('A', 2) +
              "ENDMDL\nEND\n")
              .Sizes(),
    (Sizes{ 3, 30, 30 }));
}

TEST(PDBModels, FramesBetweenEND)
{
  // VMD and CHARMM: each frame ends with END, or all but the last one.
  const std::string frames[] = { Chain('A', 0), Chain('A', 0.5), Chain('A', -1) };
  for (const std::string end : { "END\n", "TER\nEND\n", "END   \n", "END\r\n" })
  {
    for (const std::string& last : { end, std::string() })
    {
      const Reading reading("CRYST1   50.000   50.000   50.000  90.00  90.00  90.00\n" + frames[0] +
        end + frames[1] + end + frames[2] + last);
      EXPECT_EQ(reading.Sizes(), (Sizes{ 3, 30, 30 })) << end << last;
      EXPECT_TRUE(Mention(reading.First.Notes,
        "END separates 3 parts of the file, which repeat the same atoms: read as 3 models"));
    }
  }
  EXPECT_EQ(Reading(frames[0] + "END\n").Sizes(), (Sizes{ 1, 30, 30 }));
  EXPECT_EQ(Reading(frames[0] + "END\n\n\nEND\n").Sizes(), (Sizes{ 1, 30, 30 }));
  EXPECT_EQ(Reading("END\n" + frames[0] + "END\nEND\n").Sizes(), (Sizes{ 1, 30, 30 }));
  // Two identical models are two frames.
  EXPECT_EQ(Reading(frames[0] + "END\n" + frames[0]).Sizes(), (Sizes{ 2, 30, 30 }));
  // Frames that consist of several parts each.
  const std::string ligand[] = { Chain('L', 4, 1, "LIG"), Chain('L', 5, 1, "LIG") };
  const Reading groups(
    frames[0] + "END\n" + ligand[0] + "END\n" + frames[1] + "END\n" + ligand[1] + "END\n");
  EXPECT_EQ(groups.Sizes(), (Sizes{ 2, 33, 33 }));
  EXPECT_EQ(groups.Chains(), "AL");
}

namespace
{

/// The same helix in PQR (words or columns) or PDBQT.
std::string As(MoleculeFormat format, std::string pdb, bool inWords = true)
{
  std::string text;
  for (std::size_t at = 0; at < pdb.size(); at = pdb.find('\n', at) + 1)
  {
    std::string line = pdb.substr(at, pdb.find('\n', at) - at);
    if (line.substr(0, 4) != "ATOM")
    {
      text += line + "\n";
      continue;
    }
    line.resize(54);
    if (format == MoleculeFormat::PDBQT)
    {
      text += line + "  1.00 10.00     0.250 " + line[13] + " \n";
      continue;
    }
    line += "  0.2500 1.7000";
    if (inWords)
    {
      line.insert(30, " ");
    }
    text += line + "\n";
  }
  return text;
}

}

TEST(PDBModels, OfPQRAndPDBQT)
{
  // Trajectories of VMD and pdb2pqr, poses of Vina and AutoDock, receptor and ligand one after the
  // other.
  const std::string first = Chain('A', 0), second = Chain('A', 0.5),
                    ligand = Chain('A', 12, 4, "LIG");
  const struct
  {
    std::string PDB;
    std::int64_t Models;
    std::size_t Atoms;
    std::string Chains;
  } cases[] = {
    { first + "END\n" + second + "END\n" + first + "END\n", 3, 30, "A" },
    { first + "TER\nEND\n" + second, 2, 30, "A" },
    { first + "ENDMDL\n" + second + "ENDMDL\nEND\n", 2, 30, "A" },
    { "MODEL 1\n" + first + "MODEL 2\n" + second + "END\n", 2, 30, "A" },
    { "MODEL        1\n" + first + "ENDMDL\nMODEL        2\n" + second + "ENDMDL\n", 2, 30, "A" },
    { first + "END\n" + ligand + "END\n", 1, 42, "AB" },
    { first + "END\n" + Chain('A', 30) + "END\n", 1, 60, "AB" },
    { first + "TER\nEND\n", 1, 30, "A" },
  };
  for (const auto& [pdb, models, atoms, chains] : cases)
  {
    for (const auto& [format, name, inWords] : { std::tuple(MoleculeFormat::PQR, "m.pqr", true),
           std::tuple(MoleculeFormat::PQR, "m.pqr", false),
           std::tuple(MoleculeFormat::PDBQT, "m.pdbqt", true) })
    {
      const std::string text = As(format, pdb, inWords);
      const Macromolecule molecule = ParseMolecule(text, format, {});
      EXPECT_EQ(molecule.NumberOfModels, models) << name << pdb;
      EXPECT_EQ(molecule.Atoms.size(), atoms) << name << pdb;
      std::string found;
      for (const Atom& atom : molecule.Atoms)
      {
        found += found.empty() || found.back() != atom.Chain[0] ? atom.Chain : "";
      }
      EXPECT_EQ(found, chains) << name << pdb;
      const TemporaryFile plain(text, name), packed(Gzip(text), name);
      EXPECT_EQ(CountModels(plain.Path(), format), models) << name << pdb;
      EXPECT_EQ(CountModels(packed.Path(), format), models) << name << pdb;
      MoleculeOptions last;
      last.ModelIndex = models - 1;
      EXPECT_EQ(ParseMolecule(text, format, last).Atoms.size(), atoms) << name << pdb;
    }
  }
  // Messages name the line, also in a later model; errors in other models have no effect.
  const std::string damaged =
    As(MoleculeFormat::PQR, first + "END\n" + second) + "ATOM 31 C ALA A 11 x 0 0 0 1\n";
  EXPECT_NE(CatchMessage(damaged, MoleculeFormat::PQR).find("line 62: this is not an atom"),
    std::string::npos)
    << CatchMessage(damaged, MoleculeFormat::PQR);
}

TEST(PDBModels, MoleculesBetweenEND)
{
  // Docking servers: receptor and ligand, in different chains, and in the same one.
  const Reading two(Chain('A', 0) + "END\n" + Chain('B', 12, 7) + "END\n");
  EXPECT_EQ(two.Sizes(), (Sizes{ 1, 51, 51 }));
  EXPECT_EQ(two.Chains(), "AB");
  const Reading same(Chain('A', 0) + Chain('B', 30) + "END\n" + Chain('A', 12, 7) + "END\n");
  EXPECT_EQ(same.Sizes(), (Sizes{ 1, 81, 81 }));
  EXPECT_EQ(same.Chains(), "ABC");
  EXPECT_TRUE(Mention(same.First.Notes, "renamed: 1 (A of part 2 is C)."));
  // Equal parts that do not overlap: a dimer; and one that has only fused its ends.
  const Reading dimer(Chain('A', 0) + "END\n" + Chain('A', 9) + "END\n");
  EXPECT_EQ(dimer.Sizes(), (Sizes{ 1, 60, 60 }));
  EXPECT_EQ(dimer.Chains(), "AB");
  EXPECT_TRUE(Mention(dimer.First.Notes, "at places that do not overlap: read as one structure"));
  // The same number of atoms at the same places, but of another chain or residue.
  EXPECT_EQ(Reading(Chain('A', 0) + "END\n" + Chain('B', 0.5)).Sizes(), (Sizes{ 1, 60, 60 }));
  EXPECT_EQ(
    Reading(Chain('A', 0) + "END\n" + Chain('A', 0.5, 10, "GLY")).Sizes(), (Sizes{ 1, 60, 60 }));
  // Wound around each other, in the same box.
  const double half = 3.14159;
  EXPECT_EQ(Reading(Chain('A', 0) + "END\n" + Chain('A', 0, 10, "ALA", half) + "END\n").Sizes(),
    (Sizes{ 1, 60, 60 }));
  // No chain names at all.
  EXPECT_EQ(Reading(Chain(' ', 0) + "END\n" + Chain(' ', 9)).Chains(), "A");
  // More chains than letters.
  std::string many;
  for (int i = 0; i < 70; ++i)
  {
    many += Chain('A', 20.0 * i, 1) + "END\n";
  }
  const Reading crowd(many);
  EXPECT_EQ(crowd.Sizes(), (Sizes{ 1, 210, 210 }));
  EXPECT_EQ(crowd.First.Atoms[209].Chain, "A9");
}

TEST(PDBModels, RecordsOfAPartConcernItsAtoms)
{
  // Both parts count their atoms from 1, and have their own disulfide bond.
  const std::string part = "SSBOND   1 CYS A    1    CYS A    2\n" +
    AtomLine("1", " SG", "CYS A   1 ", 0, 0, 0, "  1.00  0.00           S") +
    AtomLine("2", " SG", "CYS A   2 ", 0, 0, 9, "  1.00  0.00           S") +
    AtomLine("3", " C1", "LIG A   3 ", 0, 0, 20, "  1.00  0.00           C");
  const std::string other = "SSBOND   1 CYS A    1    CYS A    2\n" +
    AtomLine("1", " SG", "CYS A   1 ", 50, 0, 0, "  1.00  0.00           S") +
    AtomLine("2", " SG", "CYS A   2 ", 50, 0, 9, "  1.00  0.00           S");
  const Macromolecule molecule =
    FromPDB(part + "CONECT    1    3\nEND\n" + other + "CONECT    2    1\nEND\n");
  EXPECT_EQ(molecule.NumberOfModels, 1);
  std::string bonds;
  for (const Bond& bond : molecule.Bonds)
  {
    bonds += std::to_string(bond.First) + "-" + std::to_string(bond.Second) + " ";
  }
  EXPECT_EQ(bonds, "0-1 0-2 3-4 ");
}

TEST(PDBModels, RecordsMayConcernAtomsOfOtherParts)
{
  // A ligand outside of the model, and CONECT records after both.
  const Macromolecule molecule = FromPDB("MODEL        1\n" +
    AtomLine("1", " SG", "CYS A   1 ", 0, 0, 0, "  1.00  0.00           S") +
    AtomLine("2", " CB", "CYS A   1 ", 9, 0, 0, "  1.00  0.00           C") + "ENDMDL\n" +
    AtomLine("3", " C1", "LIG A   3 ", 0, 0, 20, "  1.00  0.00           C", true) +
    "CONECT    1    2\nCONECT    1    3\nEND\n");
  ASSERT_EQ(molecule.Bonds.size(), 2u);
  EXPECT_EQ(molecule.Bonds[0].Second, 1);
  EXPECT_EQ(molecule.Bonds[1].Second, 2);
}

TEST(PDBModels, AreTimeSteps)
{
  const TemporaryFile file(
    Chain('A', 0) + "END\n" + Chain('A', 0.5) + "END\n" + Chain('A', 1) + "END\n", "frames.pdb");
  vtkNew<vtkMacromoleculeReader> reader;
  reader->SetFileName(file.Path());
  reader->UpdateInformation();
  vtkInformation* info = reader->GetOutputInformation(0);
  ASSERT_EQ(info->Length(vtkStreamingDemandDrivenPipeline::TIME_STEPS()), 3);
  reader->UpdateTimeStep(2.0);
  EXPECT_NEAR(reader->GetOutput()->GetPoint(0)[0], 1.0 + 2.3 * std::cos(1.75), 1e-3);
}

TEST(PDBModels, EndIsCountedAcrossTheEndsOfBlocks)
{
  // Blocks of 1 MiB are searched separately.
  constexpr std::size_t block = 1 << 20;
  const std::string frame = Chain('A', 0);
  for (std::size_t shift = 0; shift < 8; ++shift)
  {
    std::string text = frame;
    text += std::string(block - text.size() - shift, '\n') + "END\n" + frame + "END\n";
    const TemporaryFile file(text, "frames.pdb");
    EXPECT_EQ(CountModels(file.Path(), MoleculeFormat::PDB), 2) << shift;
    const TemporaryFile far(
      frame + "END\nREMARK\n" + std::string(100000 + shift, '\n') + frame, "far.pdb");
    EXPECT_EQ(CountModels(far.Path(), MoleculeFormat::PDB), 2) << shift;
    const TemporaryFile one(text.substr(0, text.find("END\n")) + "END\n", "one.pdb");
    EXPECT_EQ(CountModels(one.Path(), MoleculeFormat::PDB), 1) << shift;
  }
}

// ------------------------------------------------------------------------------------------
// Copies of a chain under one name

TEST(PDBModels, CopiesOfAChainUnderOneNameAreChains)
{
  ISTHMUS_NEEDS_SHARED_DATA("reports/r11_same_chain_TER.pdb");
  const Macromolecule twice = FromReport("r11_same_chain_TER.pdb");
  EXPECT_EQ(twice.Atoms.size(), 476u);
  EXPECT_EQ(twice.Atoms.front().Chain, "A");
  EXPECT_NE(twice.Atoms.back().Chain, "A");
  EXPECT_TRUE(Mention(twice.Notes, "A, copy 2, is B"));
  // With and without TER, without a name, three times, water and ligands behind them.
  const std::string water =
    AtomLine("1", " O", "HOH A 501 ", 3, 3, 3, "  1.00  0.00           O", true);
  for (const std::string ter : { "", "TER\n" })
  {
    const Reading three(Chain('A', 0) + ter + Chain('A', 20) + ter + Chain('A', 40) + ter + water);
    EXPECT_EQ(three.Sizes(), (Sizes{ 1, 91, 91 }));
    EXPECT_EQ(three.Chains(), "ABC");
    const Macromolecule blank = FromPDB(Chain(' ', 0) + ter + Chain(' ', 20));
    EXPECT_EQ(blank.Atoms.size(), 60u);
    EXPECT_EQ(blank.Atoms.back().Chain, "A");
  }
  // Water and ligands of a chain after TER, and atoms of a residue that come later, are none.
  const Reading one(Chain('A', 0) + "TER\n" + water);
  EXPECT_EQ(one.Chains(), "A");
  const std::string late = AtomLine("1", " CB", "ALA A   3 ", 3, 3, 3, "  1.00  0.00           C");
  EXPECT_EQ(Reading(Chain('A', 0) + late).Chains(), "A");
}
