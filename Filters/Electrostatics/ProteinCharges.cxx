#include "Electrostatics/ProteinCharges.h"

#include "Atoms/ChemicalElement.h"
#include "Core/NumberText.h"
#include "Core/PrintableText.h"

#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>
#include <tuple>

namespace isthmus
{
namespace
{

constexpr char ChainLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
constexpr std::size_t MostChains = sizeof ChainLetters - 1;
constexpr int MostResidues = 9999;

const std::string Suggestion = " Or open a PQR file.";

/// A residue of the input, and its name in the files of the child process.
struct FileResidue
{
  std::vector<std::size_t> Atoms;
  char Chain = 'A';
  int Number = 1;
  bool HasCharges = false;
};

/// Assigns letters and numbers that fit into the columns of a PDB file, whatever the names in the
/// input.
std::vector<FileResidue> FindResidues(const std::vector<NamedAtom>& atoms)
{
  std::map<std::string, std::pair<std::size_t, int>> chains; // letter's place, residues so far
  std::map<std::tuple<std::string, int, std::string, std::string>, std::size_t> known;
  std::vector<FileResidue> residues;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const NamedAtom& atom = atoms[i];
    if (atom.Name.empty() || atom.Residue.empty() || IsWater(atom.Residue))
    {
      continue;
    }
    const auto [at, isNew] =
      known.emplace(std::make_tuple(atom.Chain, atom.ResidueId, atom.InsertionCode, atom.Residue),
        residues.size());
    if (isNew)
    {
      auto& chain = chains.emplace(atom.Chain, std::make_pair(chains.size(), 0)).first->second;
      if (chain.first >= MostChains || ++chain.second > MostResidues)
      {
        throw std::invalid_argument(
          "The molecule has more than 62 chains, or more than 9,999 residues in one chain, so "
          "pdb2pqr cannot assign charges. Read fewer chains (Chains of the reader)." +
          Suggestion);
      }
      residues.push_back({ {}, ChainLetters[chain.first], chain.second, false });
    }
    residues[at->second].Atoms.push_back(i);
  }
  if (residues.empty())
  {
    throw std::invalid_argument("The atoms have no charges, and no atom and residue names by which "
                                "a force field could assign them: open a PDB, mmCIF or PQR file.");
  }
  return residues;
}

std::string PDBLine(const NamedAtom& atom, const FileResidue& residue, int serial)
{
  for (const double x : atom.Place)
  {
    if (!(std::abs(x) < 9999.0))
    {
      throw std::invalid_argument("A coordinate of an atom exceeds 9,999 angstrom, the limit of "
                                  "pdb2pqr's files: move the molecule to the origin." +
        Suggestion);
    }
  }
  // A truncated name could be that of another residue; names that do not fit are not in the force
  // field.
  const std::string name = atom.Name.size() > 4 ? "X" : atom.Name;
  const std::string kind = atom.Residue.size() > 3 ? "X" : atom.Residue;
  std::string line = LeftAligned(atom.IsHetero ? "HETATM" : "ATOM", 6) +
    RightAligned(std::to_string(serial), 5) + ' ' +
    LeftAligned((name.size() < 4 ? " " : "") + name, 4) + ' ' + RightAligned(kind, 3) + ' ' +
    residue.Chain + RightAligned(std::to_string(residue.Number), 4) + "    ";
  for (const double coordinate : atom.Place)
  {
    line += RightAligned(FixedNumber(coordinate, 3), 8);
  }
  line += "  1.00  0.00";
  return line + RightAligned(atom.Element > 0 ? ElementSymbol(atom.Element) : "", 12) + '\n';
}

void WritePDB(const std::vector<NamedAtom>& atoms, const std::vector<FileResidue>& residues,
  const std::filesystem::path& path)
{
  std::ofstream file(path);
  int serial = 0;
  for (const FileResidue& residue : residues)
  {
    for (const std::size_t atom : residue.Atoms)
    {
      serial = serial % 99999 + 1;
      file << PDBLine(atoms[atom], residue, serial);
    }
  }
  file << "END\n";
  if (!file.flush())
  {
    throw std::runtime_error("The file for pdb2pqr could not be written to " + path.string() +
      ": free some space or set TMPDIR.");
  }
}

/// The reason of the failure, from a log that ends in a traceback.
std::string ReasonIn(const std::string& log)
{
  std::string error, told;
  for (std::size_t at = 0, end = 0; at < log.size(); at = end + 1)
  {
    end = std::min(log.find('\n', at), log.size());
    const std::string line = log.substr(at, end - at);
    const std::size_t named = line.find("Error: ");
    if (named != std::string::npos && error.empty())
    {
      error = line.substr(named + 7);
    }
    for (const std::string level : { "ERROR:", "CRITICAL:" })
    {
      if (told.empty() && line.compare(0, level.size(), level) == 0)
      {
        told = line.substr(level.size());
      }
    }
  }
  const std::string reason = !error.empty() ? error : !told.empty() ? told : "it gave no reason";
  return Printable(reason.back() == '.' ? reason.substr(0, reason.size() - 1) : reason);
}

ChildResult RunWhicheverIsThere(const std::filesystem::path& folder, ChargeTable table,
  const ChildLimits& limits, const ProgressCallback& progress)
{
  const std::string field = table == ChargeTable::AMBER ? "AMBER" : "PARSE";
  ChildResult result;
  for (const char* program : { "pdb2pqr", "pdb2pqr30" })
  {
    result = RunChild({ program, "--ff=" + field, "--keep-chain", "--nodebump", "--noopt",
                        "--whitespace", folder / "protein.pdb", folder / "protein.pqr" },
      limits, folder / "log", progress);
    if (result.End != ChildEnd::NotFound)
    {
      break;
    }
  }
  return result;
}

void RequireSuccess(const ChildResult& result, const ChildLimits& limits)
{
  if (result.End == ChildEnd::NotFound || result.End == ChildEnd::NotRun)
  {
    throw std::runtime_error(
      "The atoms have no charges. The program pdb2pqr, which assigns them by a force field, is not "
      "installed: install it (Debian: apt install pdb2pqr)." +
      Suggestion);
  }
  if (result.End == ChildEnd::TimedOut)
  {
    throw std::runtime_error("The atoms have no charges, and pdb2pqr did not assign them within " +
      std::to_string(static_cast<int>(limits.TimeLimit)) + " seconds: read fewer chains." +
      Suggestion);
  }
  if (result.End == ChildEnd::Crashed || result.Code != 0)
  {
    throw std::runtime_error("The atoms have no charges, and pdb2pqr could not assign them (" +
      ReasonIn(result.Output) + "): complete the protein, or read only its complete part." +
      Suggestion);
  }
}

bool IsHydrogen(const std::string& name)
{
  const std::size_t letter = name.find_first_not_of("0123456789");
  return letter != std::string::npos && name[letter] == 'H';
}

/// The atoms of one line of the output: ATOM serial name residue chain number x y z charge radius.
class PQROutput
{
public:
  PQROutput(const std::vector<NamedAtom>& atoms, std::vector<FileResidue>& residues)
    : Atoms(atoms)
    , Residues(residues)
  {
    for (std::size_t r = 0; r < residues.size(); ++r)
    {
      this->Places[{ residues[r].Chain, residues[r].Number }] = r;
    }
  }

  void ParseLine(const std::string& line, ChargedProtein& to)
  {
    std::string_view words = line;
    ExtractWord(words); // the record's name
    ExtractWord(words); // the serial number
    ForceFieldAtom atom;
    atom.Name = ExtractWord(words);
    atom.Residue = ExtractWord(words);
    const std::string_view chain = ExtractWord(words);
    int number = 0;
    const bool complete = ExtractNumber(words, number) && ExtractNumber(words, atom.Place[0]) &&
      ExtractNumber(words, atom.Place[1]) && ExtractNumber(words, atom.Place[2]) &&
      ExtractNumber(words, atom.Charge) && ExtractNumber(words, atom.Radius);
    const auto at = this->Places.find({ chain.empty() ? ' ' : chain[0], number });
    if (!complete || at == this->Places.end())
    {
      throw std::runtime_error("pdb2pqr wrote a line that can't be read (" + Printable(line) +
        "): use version 3." + Suggestion);
    }
    FileResidue& residue = this->Residues[at->second];
    residue.HasCharges = true;
    atom.SourceAtom = residue.Atoms.front();
    atom.IsNew = true;
    for (const std::size_t i : residue.Atoms)
    {
      if (Distance(this->Atoms[i].Place, atom.Place) < 0.002)
      {
        atom.SourceAtom = i;
        atom.IsNew = false;
      }
    }
    this->Built += atom.IsNew && !IsHydrogen(atom.Name) && atom.Name != "OXT" ? 1 : 0;
    to.Atoms.push_back(atom);
  }

  std::string Warning() const
  {
    std::string list;
    int count = 0;
    for (const FileResidue& residue : this->Residues)
    {
      if (!residue.HasCharges && ++count <= 6)
      {
        const NamedAtom& atom = this->Atoms[residue.Atoms.front()];
        list += (list.empty() ? "" : ", ") + atom.Residue + " " + std::to_string(atom.ResidueId) +
          atom.InsertionCode + (atom.Chain.empty() ? "" : " " + atom.Chain);
      }
    }
    std::string text;
    if (count > 0)
    {
      text = "The force field has no charges for " + Printable(list) +
        (count > 6 ? " and " + std::to_string(count - 6) + " more" : "") +
        ": they were left out. A PQR file can contain charges for them.";
    }
    if (this->Built > 0)
    {
      text += (text.empty() ? "" : " ") + std::to_string(this->Built) +
        " atoms other than hydrogens were missing; pdb2pqr has added them.";
    }
    return text;
  }

private:
  const std::vector<NamedAtom>& Atoms;
  std::vector<FileResidue>& Residues;
  std::map<std::pair<char, int>, std::size_t> Places;
  int Built = 0;
};

}

ChargedProtein ChargeProtein(const std::vector<NamedAtom>& atoms, ChargeTable table,
  const ChildLimits& limits, const ProgressCallback& progress)
{
  std::vector<FileResidue> residues = FindResidues(atoms);
  const TemporaryFolder folder;
  WritePDB(atoms, residues, folder.Path() / "protein.pdb");
  RequireSuccess(RunWhicheverIsThere(folder.Path(), table, limits, progress), limits);
  std::ifstream file(folder.Path() / "protein.pqr");
  PQROutput answer(atoms, residues);
  ChargedProtein charged;
  std::string line;
  while (std::getline(file, line))
  {
    if (line.compare(0, 4, "ATOM") == 0 || line.compare(0, 6, "HETATM") == 0)
    {
      answer.ParseLine(line, charged);
    }
  }
  if (charged.Atoms.empty())
  {
    throw std::runtime_error("The atoms have no charges, and pdb2pqr recognised none of the "
                             "residues: it supports proteins and nucleic acids only." +
      Suggestion);
  }
  charged.Warning = answer.Warning();
  return charged;
}

}
