// Charges for atoms that have none: by pdb2pqr where it is installed, and by substitutes for it
// that answer, fail, hang, write invalid output, or are missing.

#include "Atoms/ChemicalElement.h"
#include "Electrostatics/ProteinCharges.h"
#include "GermanNumbers.h"
#include "SharedData.h"
#include "vtkPoissonBoltzmann.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sys/stat.h>

using namespace isthmus;

namespace
{

/// Meanwhile, PATH has one folder, where `script`, if any, is pdb2pqr.
class OnlyProgram
{
public:
  explicit OnlyProgram(const std::string& script)
    : Before(std::getenv("PATH"))
  {
    if (!script.empty())
    {
      const std::string file = this->Folder.Path() / "pdb2pqr";
      std::ofstream(file) << "#!/bin/sh\n" << script;
      chmod(file.c_str(), S_IRWXU);
    }
    setenv("PATH", this->Folder.Path().c_str(), 1);
  }
  ~OnlyProgram() { setenv("PATH", this->Before.c_str(), 1); }
  OnlyProgram(const OnlyProgram&) = delete;
  void operator=(const OnlyProgram&) = delete;

private:
  TemporaryFolder Folder;
  std::string Before;
};

NamedAtom MakeAtom(const char* name, const char* residue, int id, const char* chain, Point3 place,
  bool hetero = false)
{
  NamedAtom atom;
  atom.Name = name;
  atom.Residue = residue;
  atom.ResidueId = id;
  atom.Chain = chain;
  atom.Place = place;
  atom.IsHetero = hetero;
  return atom;
}

/// Glycine, alanine, water and a ligand; the chain has a name that no PDB file could have.
std::vector<NamedAtom> Molecule()
{
  return { MakeAtom("N", "GLY", 15000, "AA-2", { 1.931, 0.090, -0.034 }),
    MakeAtom("CA", "GLY", 15000, "AA-2", { 0.761, -0.799, -0.008 }),
    MakeAtom("C", "GLY", 15000, "AA-2", { -0.498, 0.029, -0.005 }),
    MakeAtom("O", "GLY", 15000, "AA-2", { -0.429, 1.235, -0.023 }),
    MakeAtom("N", "ALA", 15001, "AA-2", { -1.697, -0.574, 0.018 }),
    MakeAtom("CA", "ALA", 15001, "AA-2", { -2.923, 0.230, 0.021 }),
    MakeAtom("CB", "ALA", 15001, "AA-2", { -3.019, 1.080, 1.290 }),
    MakeAtom("C", "ALA", 15001, "AA-2", { -4.143, -0.667, -0.052 }),
    MakeAtom("O", "ALA", 15001, "AA-2", { -5.257, -0.163, 0.010 }),
    MakeAtom("OXT", "ALA", 15001, "AA-2", { -3.981, -1.890, -0.175 }),
    MakeAtom("O", "HOH", 1, "W", { 9.0, 0.0, 0.0 }, true),
    MakeAtom("C1", "LIG", 7, "", { 0.0, 9.0, 0.0 }, true) };
}

ChildLimits Short(double seconds)
{
  ChildLimits limits;
  limits.TimeLimit = seconds;
  return limits;
}

void ExpectSentence(const std::string& script, const std::string& words, double seconds = 60.0,
  const std::vector<NamedAtom>& atoms = Molecule())
{
  const OnlyProgram program(script);
  try
  {
    ChargeProtein(atoms, ChargeTable::AMBER, Short(seconds));
    ADD_FAILURE() << "no sentence with " << words;
  }
  catch (const std::exception& error)
  {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

/// Writes lines to the last argument, the PQR file.
std::string Answering(const std::string& lines)
{
  return "for last in \"$@\"; do :; done\nprintf '" + lines + "' >\"$last\"\n";
}

TEST(ProteinCharges, OutputIsMatchedResidueByResidue)
{
  const OnlyProgram program(Answering("REMARK 1\\n"
                                      "ATOM 1 N GLY A 1 1.931 0.090 -0.034 -0.5 1.8\\n"
                                      "ATOM 2 H GLY A 1 2.5 0.1 0.5 0.75 0.6\\n"
                                      "ATOM 3 CB ALA A 2 -3.019 1.080 1.290 0.25 1.9\\n"
                                      "ATOM 4 CG ALA A 2 -3.5 2.0 1.3 0.5 1.9\\nTER\\nEND\\n"));
  const ChargedProtein protein = ChargeProtein(Molecule(), ChargeTable::PARSE, Short(60));
  ASSERT_EQ(protein.Atoms.size(), 4u);
  EXPECT_EQ(protein.Atoms[0].SourceAtom, 0u);
  EXPECT_FALSE(protein.Atoms[0].IsNew);
  EXPECT_EQ(protein.Atoms[1].Name, "H");
  EXPECT_TRUE(protein.Atoms[1].IsNew);
  EXPECT_EQ(protein.Atoms[1].Charge, 0.75);
  EXPECT_EQ(protein.Atoms[2].SourceAtom, 6u);
  EXPECT_EQ(protein.Atoms[2].Radius, 1.9);
  // Water goes without a word, the ligand doesn't, nor does a heavy atom out of nowhere.
  ASSERT_EQ(protein.Uncharged.size(), 1u);
  EXPECT_EQ(protein.Uncharged[0], std::vector<std::size_t>{ 11 });
  EXPECT_NE(DescribeUncharged(Molecule(), {}, protein).find("LIG 7:"), std::string::npos);
  EXPECT_EQ(protein.Warning.find("HOH"), std::string::npos) << protein.Warning;
  EXPECT_NE(protein.Warning.find(" 1 atoms other than hydrogens"), std::string::npos);
}

TEST(ProteinCharges, InputOfTheProgramFitsItsColumns)
{
  // The program returns the given atoms, with charges by their order.
  const std::string script = "for last in \"$@\"; do before=$file; file=$last; done\n"
                             "while read -r a b c d e f g h i j; do [ \"$a\" = END ] || "
                             "echo \"$a $b $c $d $e $f $g $h $i 0.5 1.5\"; done <\"$before\" "
                             ">\"$file\"\n";
  const OnlyProgram program(script);
  const ChargedProtein protein = ChargeProtein(Molecule(), ChargeTable::AMBER, Short(60));
  ASSERT_EQ(protein.Atoms.size(), 11u); // all but water
  EXPECT_TRUE(protein.Warning.empty()) << protein.Warning;
  for (std::size_t i = 0; i < 10; ++i)
  {
    EXPECT_EQ(protein.Atoms[i].SourceAtom, i);
    EXPECT_FALSE(protein.Atoms[i].IsNew);
    EXPECT_EQ(protein.Atoms[i].Name, Molecule()[i].Name);
  }
}

TEST(ProteinCharges, EveryFailureOfTheProgramHasAMessage)
{
  ExpectSentence("", "not installed");
  ExpectSentence("echo 'ValueError: Too few atoms.' >&2; echo RuntimeError >&2; exit 1",
    "(Too few atoms): complete");
  ExpectSentence("echo CRITICAL:Giving up.; exit 3", "(Giving up)");
  ExpectSentence("exit 1", "gave no reason");
  ExpectSentence("kill -9 $$", "could not assign them");
  ExpectSentence("while :; do :; done", "seconds", 0.3);
  ExpectSentence("exit 0", "recognised none of the residues");
  ExpectSentence(Answering("ATOM 1 N GLY A one 1 2 3 4 5\\n"), "can't be read");
  ExpectSentence(Answering("ATOM 1 N GLY A 7 1 2 3 4 5\\n"), "can't be read"); // nobody's residue
  std::vector<NamedAtom> far = Molecule();
  far[3].Place[1] = -12345.0;
  ExpectSentence("exit 0", "9,999 angstrom", 60, far);
  ExpectSentence("exit 0", "no atom and residue names", 60, { NamedAtom{} });
  ChargeOptions acid;
  acid.PH = 15.0;
  EXPECT_THROW(ChargeProtein(Molecule(), acid, Short(60)), std::invalid_argument);
  std::vector<NamedAtom> many;
  for (int i = 0; i < 63; ++i)
  {
    many.push_back(MakeAtom("N", "GLY", 1, std::to_string(i).c_str(), { 1.0 * i, 0, 0 }));
  }
  ExpectSentence("exit 0", "62 chains", 60, many);
}

/// Each atom but those with the words `except` in its line, and those that come again in their
/// residue, with charge 0.5 and radius 1.5.
std::string Echoing(const std::string& except = "nothing")
{
  return "for last in \"$@\"; do before=$file; file=$last; done\n"
         "while read -r a b c d e f g h i j; do case \"$a $b $c $d $e $f\" in END*|" +
    except +
    ") ;; *) case \"$seen\" in *\"|$c $d $e $f|\"*) ;; *) seen=\"$seen|$c $d $e $f|\"; "
    "echo \"$a $b $c $d $e $f $g $h $i 0.5 1.5\";; esac;; esac; done <\"$before\" >\"$file\"\n";
}

/// With the elements of their names.
std::vector<NamedAtom> WithElements(std::vector<NamedAtom> atoms)
{
  for (NamedAtom& atom : atoms)
  {
    atom.Element = ElementFromAtomName(atom.Name, atom.Residue);
  }
  return atoms;
}

TEST(ProteinCharges, LostAtomsAreListed)
{
  const OnlyProgram program(Echoing("*' O GLY '*|*' CB '*|*' HA '*"));
  std::vector<NamedAtom> atoms = Molecule();
  atoms.push_back(MakeAtom("HA", "ALA", 15001, "AA-2", { -2.9, 0.2, 1.0 }));
  atoms = WithElements(atoms);
  const ChargedProtein protein = ChargeProtein(atoms, ChargeTable::AMBER, Short(60));
  EXPECT_NE(protein.Warning.find("left out 2 atoms: O of GLY 15000 AA-2, CB of ALA 15001 AA-2."),
    std::string::npos)
    << protein.Warning;
  ASSERT_EQ(protein.Notes.size(), 1u);
  EXPECT_NE(protein.Notes[0].find("dropped: 1 (HA of ALA 15001 AA-2)"), std::string::npos)
    << protein.Notes[0];
}

/// Two nucleotides; the program removes the phosphate of the first.
TEST(ProteinCharges, PhosphatesAtTheEndAreRestored)
{
  std::vector<NamedAtom> atoms;
  for (int r = 0; r < 2; ++r)
  {
    for (const char* name : { "P", "OP1", "OP2", "O5'", "C1'" })
    {
      const auto x = static_cast<double>(atoms.size());
      atoms.push_back(MakeAtom(name, "G", r + 1, "R", { x, 0.5, 0.25 }));
    }
  }
  const std::string rest = "ATOM 6 P RG A 2 5.000 0.500 0.250 1.2 2.1\\n"
                           "ATOM 7 OP1 RG A 2 6.000 0.500 0.250 -0.8 1.6\\n"
                           "ATOM 8 OP2 RG A 2 7.000 0.500 0.250 -0.8 1.6\\n"
                           "ATOM 9 O5' RG A 2 8.000 0.500 0.250 -0.5 1.7\\n"
                           "ATOM 10 C1' RG A 2 9.000 0.500 0.250 0.1 1.9\\n";
  const std::string first = "ATOM 1 O5' RG A 1 3.000 0.500 0.250 -0.6 1.7\\n"
                            "ATOM 2 C1' RG A 1 4.000 0.500 0.250 0.1 1.9\\n";
  const auto answer = [](std::string text)
  {
    for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 5)
    {
      text.replace(at, 1, "'\"'\"'");
    }
    return Answering(text);
  };
  const OnlyProgram program(answer(first + "ATOM 3 H5T RG A 1 3.0 1.5 0.25 0.4 0\\n" + rest));
  const ChargedProtein protein = ChargeProtein(WithElements(atoms), ChargeTable::AMBER, Short(60));
  EXPECT_TRUE(protein.Warning.empty()) << protein.Warning;
  ASSERT_EQ(protein.Notes.size(), 1u);
  EXPECT_NE(protein.Notes[0].find("G 1 R"), std::string::npos) << protein.Notes[0];
  ASSERT_EQ(protein.Atoms.size(), 10u);
  double sum = 0.0;
  for (const ForceFieldAtom& atom : protein.Atoms)
  {
    EXPECT_NE(atom.Name, "H5T");
    sum += atom.Charge;
  }
  // Before: O5' and C1' of the first, its hydrogen, and the second residue.
  EXPECT_NEAR(sum, -0.6 + 0.1 + 0.4 - 0.8 - 1.0, 1e-12);
  // Without a hydrogen in its place, it is lost, and so listed.
  const OnlyProgram other(answer(first + rest));
  EXPECT_NE(ChargeProtein(WithElements(atoms), ChargeTable::AMBER, Short(60))
              .Warning.find("left out 3 atoms: P of G 1 R, OP1 of G 1 R, OP2 of G 1 R."),
    std::string::npos);
}

// Of chains under one name, one after the other and mixed, each is a chain of the program's file.
TEST(ProteinCharges, CopiesOfAChainAreKept)
{
  const OnlyProgram program(Echoing());
  std::vector<NamedAtom> first = WithElements(Molecule());
  first.resize(10);
  std::vector<NamedAtom> both = first;
  std::vector<NamedAtom> mixed;
  for (NamedAtom atom : first)
  {
    mixed.push_back(atom);
    atom.Place[2] += 30.0;
    both.push_back(atom);
    mixed.push_back(atom);
  }
  for (const std::vector<NamedAtom>& atoms : { both, mixed })
  {
    const ChargedProtein protein = ChargeProtein(atoms, ChargeTable::AMBER, Short(60));
    EXPECT_EQ(protein.Atoms.size(), 20u);
    EXPECT_TRUE(protein.Warning.empty()) << protein.Warning;
    std::set<std::size_t> sources;
    for (const ForceFieldAtom& atom : protein.Atoms)
    {
      EXPECT_FALSE(atom.IsNew);
      sources.insert(atom.SourceAtom);
    }
    EXPECT_EQ(sources.size(), 20u);
  }
  // Alternate locations are no copies.
  std::vector<NamedAtom> alternate = first;
  alternate[6].AltLoc = "A";
  alternate[6].Occupancy = 0.4;
  alternate.push_back(alternate[6]);
  alternate.back().AltLoc = "B";
  alternate.back().Occupancy = 0.6;
  alternate.back().Place[0] += 0.5;
  const ChargedProtein one = ChargeProtein(alternate, ChargeTable::AMBER, Short(60));
  EXPECT_EQ(one.Atoms.size(), 10u);
  EXPECT_TRUE(one.Warning.empty()) << one.Warning;
}

// The program stops at the first atom that it does not know, as its log says.
TEST(ProteinCharges, AtomsThatStopTheProgramAreLeftOut)
{
  const std::string stop =
    "for last in \"$@\"; do before=$file; file=$last; done\n"
    "while read -r a b c d e; do case $c in HT2|QX) "
    "echo \"CRITICAL:Found gap in biomolecule structure for atom $a $b $c $d 7 0 0 0\"; exit 1;; "
    "esac; done <\"$before\"\n";
  const OnlyProgram program(stop + Echoing());
  std::vector<NamedAtom> atoms = Molecule();
  atoms.push_back(MakeAtom("HT2", "ALA", 15001, "AA-2", { -2.9, 0.2, 1.0 }));
  atoms.push_back(MakeAtom("HT2", "GLY", 15000, "AA-2", { 0.7, -0.7, 1.0 }));
  atoms.push_back(MakeAtom("QX", "GLY", 15000, "AA-2", { 0.7, -0.7, -1.0 }));
  atoms = WithElements(atoms);
  const ChargedProtein protein = ChargeProtein(atoms, ChargeTable::AMBER, Short(60));
  EXPECT_EQ(protein.Atoms.size(), 11u); // ten, and the ligand
  EXPECT_NE(protein.Warning.find("left out 1 atom: QX of GLY 15000 AA-2."), std::string::npos)
    << protein.Warning;
  ASSERT_EQ(protein.Notes.size(), 1u);
  EXPECT_NE(
    protein.Notes[0].find("HT2 of GLY 15000 AA-2, HT2 of ALA 15001 AA-2"), std::string::npos)
    << protein.Notes[0];
}

TEST(ProteinCharges, ArgumentsForPROPKA)
{
  const OnlyProgram program("echo \"Error: $*\" >&2; exit 1\n");
  ChargeOptions acid;
  acid.UsePropka = true;
  acid.PH = 4.5;
  for (const bool isUsed : { true, false })
  {
    acid.UsePropka = isUsed;
    try
    {
      ChargeProtein(Molecule(), acid, Short(60));
      ADD_FAILURE();
    }
    catch (const std::runtime_error& error)
    {
      const std::string said = error.what();
      EXPECT_EQ(
        said.find("--titration-state-method=propka --with-ph=4.50") != std::string::npos, isUsed)
        << said;
    }
  }
}

/// A ligand with two heavy atoms and a hydrogen, as a MOL2 file has it, moved by `z`.
std::vector<LigandAtom> Ligand(double z, const char* name = "C1")
{
  return { { MakeAtom(name, "LIG", 1, "", { 0.0, 9.0, z }), 0.3, 1.7 },
    { MakeAtom("H1", "LIG", 1, "", { 0.0, 10.0, z }), 0.2, 1.2 },
    { MakeAtom("C9", "OTH", 2, "", { 0.0, 0.0, z + 50.0 }), 9.0, 1.7 } };
}

std::vector<LigandAtom> WithElements(std::vector<LigandAtom> atoms)
{
  for (LigandAtom& atom : atoms)
  {
    atom.Named.Element = ElementFromAtomName(atom.Named.Name, atom.Named.Residue);
  }
  return atoms;
}

TEST(ProteinCharges, OfLigandsByPlaceOrName)
{
  const std::vector<NamedAtom> atoms = WithElements(Molecule());
  ChargedProtein none;
  none.Uncharged = { { 11 } };
  // At the same place, whatever the names: the hydrogen comes along.
  ChargedProtein placed = none;
  AddLigandCharges(atoms, WithElements(Ligand(0.1, "CX")), placed);
  ASSERT_EQ(placed.Atoms.size(), 2u);
  EXPECT_EQ(placed.Atoms[0].Charge, 0.3);
  EXPECT_EQ(placed.Atoms[0].SourceAtom, 11u);
  EXPECT_TRUE(placed.Atoms[1].IsNew);
  EXPECT_EQ(placed.Atoms[1].Charge, 0.2);
  EXPECT_TRUE(placed.Uncharged.empty());
  EXPECT_NE(placed.Notes.at(0).find("by place: 0.500 e"), std::string::npos) << placed.Notes[0];
  // Elsewhere, by name: its charge goes to the carbon.
  ChargedProtein named = none;
  AddLigandCharges(atoms, WithElements(Ligand(20.0)), named);
  ASSERT_EQ(named.Atoms.size(), 1u);
  EXPECT_NEAR(named.Atoms[0].Charge, 0.5, 1e-12);
  EXPECT_EQ(named.Atoms[0].Place, atoms[11].Place);
  // Neither; a charge that is missing.
  ChargedProtein left = none;
  AddLigandCharges(atoms, WithElements(Ligand(20.0, "CX")), left);
  std::vector<LigandAtom> unknown = WithElements(Ligand(0.0));
  unknown[0].Charge = std::nan("");
  AddLigandCharges(atoms, unknown, left);
  EXPECT_TRUE(left.Atoms.empty());
  ASSERT_EQ(left.Uncharged.size(), 1u);
  std::vector<double> formal(atoms.size(), std::nan(""));
  formal[11] = 2.0;
  EXPECT_NE(
    DescribeUncharged(atoms, formal, left).find("LIG 7 (formal charge 2)"), std::string::npos);
}

vtkSmartPointer<vtkPolyData> Points(const std::vector<NamedAtom>& atoms)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkStringArray> names, residues, chains;
  vtkNew<vtkIntArray> ids;
  vtkNew<vtkDoubleArray> charges;
  for (const NamedAtom& atom : atoms)
  {
    points->InsertNextPoint(atom.Place.data());
    names->InsertNextValue(atom.Name);
    residues->InsertNextValue(atom.Residue);
    chains->InsertNextValue(atom.Chain);
    ids->InsertNextValue(atom.ResidueId);
    charges->InsertNextValue(std::nan(""));
  }
  data->SetPoints(points);
  vtkAbstractArray* const arrays[] = { names, residues, chains, ids, charges };
  const char* const called[] = { "AtomName", "ResidueName", "Chain", "ResidueId", "Charge" };
  for (int a = 0; a < 5; ++a)
  {
    arrays[a]->SetName(called[a]);
    data->GetPointData()->AddArray(arrays[a]);
  }
  return data;
}

/// Coordinates written for pdb2pqr and charges read from it do not depend on the host's locale.
TEST(ProteinCharges, AreTheSameInAGermanLocale)
{
  if (std::system("command -v pdb2pqr >/dev/null") != 0)
  {
    ASSERT_FALSE(isthmus::testing::SharedDataRequired()) << "pdb2pqr is not installed.";
    GTEST_SKIP() << "pdb2pqr is not installed.";
  }
  const auto charged = [] { return ChargeProtein(Molecule(), ChargeTable::PARSE, Short(60.0)); };
  const ChargedProtein wanted = charged();
  const isthmus::testing::GermanNumbers german;
  ISTHMUS_NEEDS_GERMAN(german);
  const ChargedProtein made = charged();
  ASSERT_EQ(made.Atoms.size(), wanted.Atoms.size());
  for (std::size_t i = 0; i < made.Atoms.size(); ++i)
  {
    EXPECT_EQ(made.Atoms[i].Place, wanted.Atoms[i].Place);
    EXPECT_EQ(made.Atoms[i].Charge, wanted.Atoms[i].Charge);
    EXPECT_EQ(made.Atoms[i].Radius, wanted.Atoms[i].Radius);
  }
  EXPECT_EQ(made.Warning, wanted.Warning);
}

TEST(ProteinCharges, FilterSolvesForAtomsWithoutCharges)
{
  if (std::system("command -v pdb2pqr >/dev/null") != 0)
  {
    // In CI, where it is installed, its absence is a failure.
    ASSERT_FALSE(isthmus::testing::SharedDataRequired()) << "pdb2pqr is not installed.";
    GTEST_SKIP() << "pdb2pqr is not installed.";
  }
  vtkNew<vtkPoissonBoltzmann> filter;
  vtkNew<vtkTest::ErrorObserver> told;
  filter->AddObserver(vtkCommand::WarningEvent, told);
  filter->SetInputDataObject(0, Points(Molecule()));
  filter->SetSpacing(0.6);
  double energies[2];
  for (const int field : { vtkPoissonBoltzmann::AMBER, vtkPoissonBoltzmann::PARSE })
  {
    filter->SetForceField(field);
    filter->Update();
    vtkPointSet* atoms = filter->GetAtoms();
    // Gly-Ala, zwitterion: 20 atoms, the charges of its ends cancel.
    ASSERT_EQ(atoms->GetNumberOfPoints(), 20);
    vtkDataArray* charges = atoms->GetPointData()->GetArray("Charge");
    double sum = 0.0;
    for (vtkIdType i = 0; i < 20; ++i)
    {
      sum += charges->GetTuple1(i);
    }
    EXPECT_NEAR(sum, 0.0, 1e-3);
    EXPECT_EQ(atoms->GetPointData()->GetArray("ResidueId")->GetTuple1(19), 15001.0);
    energies[field] =
      filter->GetOutput()->GetFieldData()->GetArray("SolvationEnergy")->GetTuple1(0);
    EXPECT_LT(energies[field], -30.0);
  }
  EXPECT_NE(energies[0], energies[1]);
  EXPECT_NE(told->GetWarningMessage().find("LIG 7"), std::string::npos);
}

TEST(ProteinCharges, FilterReportsAMissingProgramOnce)
{
  const OnlyProgram none("");
  vtkNew<vtkPoissonBoltzmann> filter;
  vtkNew<vtkTest::ErrorObserver> told;
  filter->AddObserver(vtkCommand::ErrorEvent, told);
  filter->SetInputDataObject(0, Points(Molecule()));
  filter->Update();
  EXPECT_NE(told->GetErrorMessage().find("apt install pdb2pqr"), std::string::npos)
    << told->GetErrorMessage();
  told->Clear();
  filter->Update();
  EXPECT_FALSE(told->GetError()) << told->GetErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetSurface()->GetNumberOfPoints(), 0);
}

}
