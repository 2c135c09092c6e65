#include "Electrostatics/ProteinCharges.h"

#include "Atoms/ChemicalElement.h"
#include "Core/NumberText.h"
#include "Core/PrintableText.h"
#include "Core/RangeChecks.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace isthmus
{
namespace
{

constexpr char ChainLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789";
constexpr std::size_t MostChains = sizeof ChainLetters - 1;
constexpr int MostResidues = 9999;
constexpr std::size_t MostSerials = 99999;

const std::string Suggestion = " Or open a PQR file.";

/// A residue of the input, and its name in the files of the child process.
struct FileResidue
{
  std::vector<std::size_t> Atoms;
  char Chain = 'A';
  int Number = 1;
  std::size_t Copy = 0; ///< of its chain
  bool HasCharges = false;
};

/// All but water, and of alternate locations the most occupied ones.
std::vector<std::size_t> ChooseAtoms(const std::vector<NamedAtom>& atoms)
{
  PolymerOptions all;
  all.Hydrogens = all.Ions = all.Ligands = all.ProstheticGroups = true;
  std::vector<std::size_t> chosen = ChoosePolymer(atoms, all).Kept;
  chosen.erase(
    std::remove_if(chosen.begin(), chosen.end(),
      [&atoms](std::size_t i) { return atoms[i].Name.empty() || atoms[i].Residue.empty(); }),
    chosen.end());
  return chosen;
}

/// Assigns letters and numbers that fit into the columns of a PDB file, whatever the names in the
/// input. An atom that comes again in its residue is of a copy of the chain.
std::vector<FileResidue> FindResidues(const std::vector<NamedAtom>& atoms)
{
  using Copy = std::size_t;
  using Key = std::tuple<std::string, int, std::string, std::string>;
  std::map<std::pair<std::string, Copy>, std::pair<std::size_t, int>> chains; // letter, residues
  std::map<std::pair<Key, Copy>, std::size_t> known;
  std::map<std::pair<Key, std::string>, Copy> seen; // how often each atom has come
  std::vector<FileResidue> residues;
  for (const std::size_t i : ChooseAtoms(atoms))
  {
    const NamedAtom& atom = atoms[i];
    const Key key{ atom.Chain, atom.ResidueId, atom.InsertionCode, atom.Residue };
    const Copy copy = seen[{ key, atom.Name }]++;
    const auto [at, isNew] = known.emplace(std::make_pair(key, copy), residues.size());
    if (isNew)
    {
      auto& chain =
        chains.emplace(std::make_pair(atom.Chain, copy), std::make_pair(chains.size(), 0))
          .first->second;
      if (chain.first >= MostChains || ++chain.second > MostResidues)
      {
        throw std::invalid_argument(
          "The molecule has more than 62 chains, or more than 9,999 residues in one chain, so "
          "pdb2pqr cannot assign charges. Read fewer chains (Chains of the reader)." +
          Suggestion);
      }
      residues.push_back({ {}, ChainLetters[chain.first], chain.second, copy, false });
    }
    residues[at->second].Atoms.push_back(i);
  }
  if (residues.empty())
  {
    throw std::invalid_argument("The atoms have no charges, and no atom and residue names by which "
                                "a force field could assign them: open a PDB, mmCIF or PQR file.");
  }
  // A copy is written after what it is a copy of, not between its residues.
  std::stable_sort(residues.begin(), residues.end(),
    [](const FileResidue& a, const FileResidue& b) { return a.Copy < b.Copy; });
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

/// Returns the atoms in the order of their serial numbers, which start again after 99,999.
std::vector<std::size_t> WritePDB(const std::vector<NamedAtom>& atoms,
  const std::vector<FileResidue>& residues, const std::set<std::size_t>& leftOut,
  const std::filesystem::path& path)
{
  std::ofstream file(path);
  std::vector<std::size_t> written;
  for (const FileResidue& residue : residues)
  {
    for (const std::size_t atom : residue.Atoms)
    {
      if (leftOut.count(atom) == 0)
      {
        file << PDBLine(atoms[atom], residue, static_cast<int>(written.size() % MostSerials) + 1);
        written.push_back(atom);
      }
    }
  }
  file << "END\n";
  if (!file.flush())
  {
    throw std::runtime_error("The file for pdb2pqr could not be written to " + path.string() +
      ": free some space or set TMPDIR.");
  }
  return written;
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

ChildResult RunWhicheverIsThere(const std::filesystem::path& folder, const ChargeOptions& options,
  const ChildLimits& limits, const ProgressCallback& progress)
{
  const std::string field = options.Table == ChargeTable::AMBER ? "AMBER" : "PARSE";
  std::vector<std::string> arguments{ "", "--ff=" + field, "--keep-chain", "--nodebump", "--noopt",
    "--whitespace" };
  if (options.UsePropka)
  {
    arguments.insert(arguments.end(),
      { "--titration-state-method=propka", "--with-ph=" + FixedNumber(options.PH, 2) });
  }
  arguments.push_back((folder / "protein.pdb").string());
  arguments.push_back((folder / "protein.pqr").string());
  ChildResult result;
  for (const char* program : { "pdb2pqr", "pdb2pqr30" })
  {
    arguments[0] = program;
    result = RunChild(arguments, limits, folder / "log", progress);
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

/// "GLY 15 A"
std::string DescribeResidue(const NamedAtom& atom)
{
  return atom.Residue + " " + std::to_string(atom.ResidueId) + atom.InsertionCode +
    (atom.Chain.empty() ? "" : " " + atom.Chain);
}

bool IsHydrogen(const std::string& name)
{
  const std::size_t letter = name.find_first_not_of("0123456789");
  return letter != std::string::npos && name[letter] == 'H';
}

/// The atom at which the program gave up, as its log names it: "Found gap in biomolecule structure
/// for atom ATOM 9999 HT2 LEU 129 ...". Its force field does not know the atom.
std::optional<std::size_t> FindUnknownAtom(const std::string& log,
  const std::vector<NamedAtom>& atoms, const std::vector<std::size_t>& written)
{
  constexpr std::string_view said = "Found gap in biomolecule structure for atom";
  const std::size_t at = log.find(said);
  if (at == std::string::npos)
  {
    return {};
  }
  std::string_view words = std::string_view(log).substr(at + said.size());
  words = words.substr(0, words.find('\n'));
  ExtractWord(words); // ATOM
  std::size_t serial = 0;
  if (!ExtractNumber(words, serial) || serial == 0)
  {
    return {};
  }
  const std::string_view name = ExtractWord(words);
  for (std::size_t i = serial - 1; i < written.size(); i += MostSerials)
  {
    if (atoms[written[i]].Name == name)
    {
      return written[i];
    }
  }
  return {};
}

/// Runs the program, without the atoms that it does not know.
void RunUntilKnown(const std::vector<NamedAtom>& atoms, const std::vector<FileResidue>& residues,
  const TemporaryFolder& folder, const ChargeOptions& options, const ChildLimits& limits,
  const ProgressCallback& progress)
{
  constexpr std::size_t mostRuns = 25; // each takes seconds
  std::set<std::size_t> unknown;
  std::set<std::pair<std::string, std::string>> names; // of residues and their unknown atoms
  for (std::size_t run = 1;; ++run)
  {
    const std::vector<std::size_t> written =
      WritePDB(atoms, residues, unknown, folder.Path() / "protein.pdb");
    const ChildResult result = RunWhicheverIsThere(folder.Path(), options, limits, progress);
    const auto next = result.End == ChildEnd::Exited && result.Code != 0 && run < mostRuns
      ? FindUnknownAtom(result.Output, atoms, written)
      : std::nullopt;
    if (!next)
    {
      RequireSuccess(result, limits);
      return;
    }
    const NamedAtom& atom = atoms[*next];
    unknown.insert(*next);
    if (!names.emplace(atom.Residue, atom.Name).second)
    {
      for (const std::size_t i : written) // all of them rather than one in each run
      {
        if (atoms[i].Residue == atom.Residue && atoms[i].Name == atom.Name)
        {
          unknown.insert(i);
        }
      }
    }
  }
}

/// "P of G 2 R, OP1 of G 2 R and 3 more"
std::string ListAtoms(const std::vector<NamedAtom>& atoms, const std::vector<std::size_t>& which)
{
  constexpr std::size_t most = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(which.size(), most); ++i)
  {
    const NamedAtom& atom = atoms[which[i]];
    list += (i == 0 ? "" : ", ") + atom.Name + " of " + DescribeResidue(atom);
  }
  return Printable(list) +
    (which.size() > most ? " and " + std::to_string(which.size() - most) + " more" : "");
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
    if (!atom.IsNew)
    {
      this->Found.insert(atom.SourceAtom);
    }
    this->Built += atom.IsNew && !IsHydrogen(atom.Name) && atom.Name != "OXT" ? 1 : 0;
    to.Atoms.push_back(atom);
  }

  /// What did not come back, and what came in addition.
  void Complete(ChargedProtein& to) const
  {
    std::vector<std::size_t> lost;
    std::vector<std::size_t> hydrogens;
    for (std::size_t r = 0; r < this->Residues.size(); ++r)
    {
      const FileResidue& residue = this->Residues[r];
      const std::size_t before = lost.size();
      if (!residue.HasCharges)
      {
        to.Uncharged.push_back(residue.Atoms);
        continue;
      }
      for (const std::size_t i : residue.Atoms)
      {
        const NamedAtom& atom = this->Atoms[i];
        const bool isHydrogen = atom.Element == 1 || (atom.Element == 0 && IsHydrogen(atom.Name));
        if (this->Found.count(i) == 0)
        {
          (isHydrogen ? hydrogens : lost).push_back(i);
        }
      }
      const std::vector<std::size_t> ofResidue(
        lost.begin() + static_cast<std::ptrdiff_t>(before), lost.end());
      if (this->RestorePhosphate(r, ofResidue, to))
      {
        lost.resize(before);
      }
    }
    if (!lost.empty())
    {
      to.Warning = "pdb2pqr has left out " + std::to_string(lost.size()) +
        (lost.size() == 1 ? " atom: " : " atoms: ") + ListAtoms(this->Atoms, lost) +
        ". Their charges are missing in the sum.";
    }
    if (!hydrogens.empty())
    {
      to.Notes.push_back("Hydrogens that the force field does not know, dropped: " +
        std::to_string(hydrogens.size()) + " (" + ListAtoms(this->Atoms, hydrogens) + ").");
    }
    if (this->Built > 0)
    {
      to.Warning += (to.Warning.empty() ? "" : " ") + std::to_string(this->Built) +
        " atoms other than hydrogens were missing; pdb2pqr has modelled them.";
    }
  }

private:
  static bool IsPhosphateOxygen(const std::string& name)
  {
    static const std::set<std::string> names{ "OP1", "OP2", "OP3", "O1P", "O2P", "O3P" };
    return names.count(name) > 0;
  }

  /// The atom of a residue with a name in the answer, or null.
  ForceFieldAtom* FindInAnswer(
    std::size_t residue, const std::set<std::string>& names, ChargedProtein& in) const
  {
    for (ForceFieldAtom& atom : in.Atoms)
    {
      const auto& own = this->Residues[residue].Atoms;
      if (names.count(atom.Name) > 0 &&
        std::find(own.begin(), own.end(), atom.SourceAtom) != own.end())
      {
        return &atom;
      }
    }
    return nullptr;
  }

  /**
   * A phosphate at the 5' end, which the program removes and replaces by a hydrogen. Its atoms get
   * the charges that those of another residue have; what is missing to the charge of a phosphate
   * with one proton, -1 e, is divided among its oxygens other than O5'. False: it is something
   * else, or no residue has a phosphate.
   */
  bool RestorePhosphate(
    std::size_t residue, const std::vector<std::size_t>& lost, ChargedProtein& to) const
  {
    const bool isPhosphate = std::all_of(lost.begin(), lost.end(),
      [this](std::size_t i)
      { return this->Atoms[i].Name == "P" || IsPhosphateOxygen(this->Atoms[i].Name); });
    const auto oxygens = static_cast<double>(lost.size()) - 1.0;
    ForceFieldAtom* const link = this->FindInAnswer(residue, { "O5'", "O5*" }, to);
    ForceFieldAtom* const hydrogen = this->FindInAnswer(residue, { "H5T", "HO5'" }, to);
    const auto other = std::find_if(to.Atoms.begin(), to.Atoms.end(),
      [](const ForceFieldAtom& atom) { return atom.Name == "P" && !atom.IsNew; });
    if (!isPhosphate || lost.size() < 3 || !link || !hydrogen || other == to.Atoms.end())
    {
      return false;
    }
    const std::size_t source = other->SourceAtom;
    const auto holder = std::find_if(this->Residues.begin(), this->Residues.end(),
      [source](const FileResidue& r)
      { return std::find(r.Atoms.begin(), r.Atoms.end(), source) != r.Atoms.end(); });
    const auto from = static_cast<std::size_t>(holder - this->Residues.begin());
    const ForceFieldAtom phosphorus = *other;
    const ForceFieldAtom* const oxygen = this->FindInAnswer(from, { "OP1", "O1P" }, to);
    const ForceFieldAtom* const linked = this->FindInAnswer(from, { "O5'", "O5*" }, to);
    if (!oxygen || !linked)
    {
      return false;
    }
    const double change = phosphorus.Charge + oxygens * oxygen->Charge + linked->Charge -
      link->Charge - hydrogen->Charge;
    const double missing = (-1.0 - change) / oxygens;
    const ForceFieldAtom model = *oxygen;
    link->Charge = linked->Charge;
    link->Radius = linked->Radius;
    to.Atoms.erase(to.Atoms.begin() + (hydrogen - to.Atoms.data()));
    for (const std::size_t i : lost)
    {
      const bool isCenter = this->Atoms[i].Name == "P";
      to.Atoms.push_back(
        { this->Atoms[i].Place, isCenter ? phosphorus.Charge : model.Charge + missing,
          isCenter ? phosphorus.Radius : model.Radius, this->Atoms[i].Name, this->Atoms[i].Residue,
          i, false });
    }
    to.Notes.push_back("The phosphate at the 5' end, " +
      Printable(DescribeResidue(this->Atoms[lost.front()])) +
      ", which pdb2pqr leaves out, has the charges of the other ones and one proton (-1 e).");
    return true;
  }

  const std::vector<NamedAtom>& Atoms;
  std::vector<FileResidue>& Residues;
  std::map<std::pair<char, int>, std::size_t> Places;
  std::set<std::size_t> Found; ///< atoms that came back
  int Built = 0;
};

}

void Check(const ChargeOptions& options)
{
  RequireChoice("ForceField", options.Table, ChargeTable::PARSE);
  RequireRange("PH", options.PH, 0.0, 14.0);
}

ChargedProtein ChargeProtein(const std::vector<NamedAtom>& atoms, const ChargeOptions& options,
  const ChildLimits& limits, const ProgressCallback& progress)
{
  Check(options);
  std::vector<FileResidue> residues = FindResidues(atoms);
  const TemporaryFolder folder;
  RunUntilKnown(atoms, residues, folder, options, limits, progress);
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
  answer.Complete(charged);
  return charged;
}

namespace
{

bool IsHeavy(const NamedAtom& atom)
{
  return atom.Element != 1 && !(atom.Element == 0 && IsHydrogen(atom.Name));
}

/// Charges for one residue; empty if some heavy atom has none.
class LigandMatch
{
public:
  LigandMatch(const std::vector<NamedAtom>& atoms, const std::vector<LigandAtom>& ligands)
    : Atoms(atoms)
    , Ligands(ligands)
  {
  }

  std::vector<ForceFieldAtom> Find(const std::vector<std::size_t>& residue, bool& isByName) const
  {
    isByName = false;
    std::vector<std::size_t> same = this->SameAtoms(residue,
      [this](const NamedAtom& a, const NamedAtom& b)
      {
        constexpr double nearest = 0.5;
        return a.Element == b.Element && Distance(a.Place, b.Place) < nearest;
      });
    if (same.empty())
    {
      isByName = true;
      same = this->SameAtoms(residue,
        [](const NamedAtom& a, const NamedAtom& b)
        { return a.Name == b.Name && a.Residue == b.Residue; });
    }
    return same.empty() ? std::vector<ForceFieldAtom>() : this->Charge(residue, same, isByName);
  }

private:
  /// The ligand's atom of each atom of a residue, `None` for hydrogens that it does not have.
  template <typename Same>
  std::vector<std::size_t> SameAtoms(const std::vector<std::size_t>& residue, Same same) const
  {
    std::vector<std::size_t> found;
    for (const std::size_t i : residue)
    {
      std::size_t at = None;
      for (std::size_t k = 0; at == None && k < this->Ligands.size(); ++k)
      {
        const LigandAtom& ligand = this->Ligands[k];
        at = std::isfinite(ligand.Charge) && same(this->Atoms[i], ligand.Named) ? k : at;
      }
      if (at == None && IsHeavy(this->Atoms[i]))
      {
        return {};
      }
      found.push_back(at);
    }
    return found;
  }

  std::vector<ForceFieldAtom> Charge(const std::vector<std::size_t>& residue,
    const std::vector<std::size_t>& same, bool isByName) const
  {
    std::vector<ForceFieldAtom> charged;
    std::vector<std::size_t> of; // the ligand's atom of each
    for (std::size_t i = 0; i < residue.size(); ++i)
    {
      if (same[i] != None)
      {
        const LigandAtom& ligand = this->Ligands[same[i]];
        const NamedAtom& atom = this->Atoms[residue[i]];
        charged.push_back(
          { atom.Place, ligand.Charge, ligand.Radius, atom.Name, atom.Residue, residue[i], false });
        of.push_back(same[i]);
      }
    }
    for (std::size_t k = 0; k < this->Ligands.size(); ++k)
    {
      const LigandAtom& hydrogen = this->Ligands[k];
      if (IsHeavy(hydrogen.Named) || !std::isfinite(hydrogen.Charge) ||
        std::find(of.begin(), of.end(), k) != of.end())
      {
        continue;
      }
      const std::optional<std::size_t> bonded = this->BondedTo(hydrogen, of);
      if (bonded && isByName)
      {
        charged[*bonded].Charge += hydrogen.Charge;
      }
      else if (bonded)
      {
        charged.push_back({ hydrogen.Named.Place, hydrogen.Charge, hydrogen.Radius,
          hydrogen.Named.Name, charged[*bonded].Residue, charged[*bonded].SourceAtom, true });
      }
    }
    return charged;
  }

  /// The one of `of` to which a hydrogen of the ligand is bonded.
  std::optional<std::size_t> BondedTo(
    const LigandAtom& hydrogen, const std::vector<std::size_t>& of) const
  {
    constexpr double longest = 1.5; // to sulphur or phosphorus
    std::optional<std::size_t> nearest;
    double least = longest;
    for (std::size_t i = 0; i < of.size(); ++i)
    {
      const NamedAtom& atom = this->Ligands[of[i]].Named;
      const double distance = Distance(atom.Place, hydrogen.Named.Place);
      if (IsHeavy(atom) && distance < least)
      {
        least = distance;
        nearest = i;
      }
    }
    return nearest;
  }

  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  const std::vector<NamedAtom>& Atoms;
  const std::vector<LigandAtom>& Ligands;
};

}

void AddLigandCharges(const std::vector<NamedAtom>& atoms, const std::vector<LigandAtom>& ligands,
  ChargedProtein& protein)
{
  const LigandMatch match(atoms, ligands);
  std::vector<std::vector<std::size_t>> left;
  for (const std::vector<std::size_t>& residue : protein.Uncharged)
  {
    bool isByName = false;
    const std::vector<ForceFieldAtom> charged = match.Find(residue, isByName);
    if (charged.empty())
    {
      left.push_back(residue);
      continue;
    }
    double sum = 0.0;
    for (const ForceFieldAtom& atom : charged)
    {
      sum += atom.Charge;
    }
    protein.Atoms.insert(protein.Atoms.end(), charged.begin(), charged.end());
    protein.Notes.push_back("Charges of " + Printable(DescribeResidue(atoms[residue.front()])) +
      " are those of the second input, by " + (isByName ? "name" : "place") + ": " +
      FixedNumber(sum, 3) + " e in all.");
  }
  protein.Uncharged = left;
}

std::string DescribeUncharged(const std::vector<NamedAtom>& atoms,
  const std::vector<double>& formalCharges, const ChargedProtein& protein)
{
  constexpr std::size_t most = 6;
  std::string list;
  for (std::size_t r = 0; r < std::min(protein.Uncharged.size(), most); ++r)
  {
    const std::vector<std::size_t>& residue = protein.Uncharged[r];
    double formal = 0.0;
    for (const std::size_t i : residue)
    {
      formal +=
        i < formalCharges.size() && std::isfinite(formalCharges[i]) ? formalCharges[i] : 0.0;
    }
    list += (r == 0 ? "" : ", ") + DescribeResidue(atoms[residue.front()]) +
      (formal != 0.0 ? " (formal charge " + FormatNumber(formal) + ")" : "");
  }
  if (list.empty())
  {
    return {};
  }
  return "The force field has no charges for " + Printable(list) +
    (protein.Uncharged.size() > most
        ? " and " + std::to_string(protein.Uncharged.size() - most) + " more"
        : "") +
    ": they were left out. Charges of a MOL2 or PQR file can be added with Force Field Charges And "
    "Ligands.";
}

}
