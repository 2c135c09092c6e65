#include "Atoms/PolymerResidues.h"

#include <string>

namespace isthmus
{
namespace
{

constexpr double LongestPeptideBond = 2.0; ///< 1.33 angstrom with a tolerance for errors of models
constexpr double LongestPhosphodiester = 2.2;
constexpr double LongestStep = 4.5; ///< CA to CA: 2.9 (cis) or 3.8 angstrom
constexpr double LongestNucleotideStep = 8.0;

bool InSameResidue(const NamedAtom& a, const NamedAtom& b)
{
  return a.ResidueId == b.ResidueId && a.Chain == b.Chain && a.Residue == b.Residue &&
    a.InsertionCode == b.InsertionCode;
}

void NameAtom(const NamedAtom& atom, std::size_t index, PolymerResidue& residue)
{
  const auto at = static_cast<std::int64_t>(index);
  const std::string& name = atom.Name;
  if (name == "N")
  {
    residue.N = at;
  }
  else if (name == "CA" && (atom.Element == 6 || atom.Element == 0))
  {
    residue.CA = at;
  }
  else if (name == "C")
  {
    residue.C = at;
  }
  else if (name == "O" || (residue.O < 0 && (name == "OT1" || name == "O1" || name == "OXT")))
  {
    residue.O = at;
  }
  else if (name == "P")
  {
    residue.P = at;
  }
  else if (name == "C4'" || name == "C4*")
  {
    residue.C4 = at;
  }
  else if (name == "O3'" || name == "O3*")
  {
    residue.O3 = at;
  }
}

/// Names with which residues of chains begin, of all atoms or of traces. Other names can occur
/// twice: old files have alternate locations without a letter.
bool IsFirstName(const std::string& name)
{
  return name == "N" || name == "CA" || name == "P" || name == "O5'" || name == "O5*" ||
    name == "C4'" || name == "C4*";
}

/// Purines have N9; of them N1 faces the other strand, of pyrimidines N3.
std::int64_t FindBaseEnd(const std::vector<NamedAtom>& atoms, const PolymerResidue& residue)
{
  std::int64_t n1 = PolymerResidue::None;
  std::int64_t n3 = PolymerResidue::None;
  bool isPurine = false;
  for (const std::size_t i : residue.Atoms)
  {
    const std::string& name = atoms[i].Name;
    n1 = name == "N1" ? static_cast<std::int64_t>(i) : n1;
    n3 = name == "N3" ? static_cast<std::int64_t>(i) : n3;
    isPurine = isPurine || name == "N9";
  }
  return isPurine ? n1 : n3;
}

void CompleteResidue(const std::vector<NamedAtom>& atoms, PolymerResidue& residue)
{
  if (residue.CA != PolymerResidue::None)
  {
    residue.Kind = ResidueKind::AminoAcid;
  }
  else if (residue.C4 != PolymerResidue::None || residue.P != PolymerResidue::None)
  {
    residue.Kind = ResidueKind::Nucleotide;
    residue.BaseEnd = FindBaseEnd(atoms, residue);
  }
}

/// Whether both atoms exist and are within the distance; `otherwise` if one is missing.
template <typename Otherwise>
bool AreNear(const std::vector<NamedAtom>& atoms, std::int64_t a, std::int64_t b, double most,
  Otherwise&& otherwise)
{
  if (a < 0 || b < 0)
  {
    return otherwise();
  }
  return Distance(atoms[static_cast<std::size_t>(a)].Place,
           atoms[static_cast<std::size_t>(b)].Place) <= most;
}

}

bool AreLinked(
  const std::vector<NamedAtom>& atoms, const PolymerResidue& a, const PolymerResidue& b)
{
  if (a.Kind != b.Kind || a.Kind == ResidueKind::Other ||
    atoms[a.Atoms.front()].Chain != atoms[b.Atoms.front()].Chain)
  {
    return false;
  }
  const bool isProtein = a.Kind == ResidueKind::AminoAcid;
  const auto byStep = [&]
  {
    return AreNear(atoms, a.Trace(), b.Trace(), isProtein ? LongestStep : LongestNucleotideStep,
      [] { return false; });
  };
  return isProtein ? AreNear(atoms, a.C, b.N, LongestPeptideBond, byStep)
                   : AreNear(atoms, a.O3, b.P, LongestPhosphodiester, byStep);
}

std::vector<PolymerResidue> FindResidues(
  const std::vector<NamedAtom>& atoms, const std::vector<std::size_t>& kept)
{
  std::vector<PolymerResidue> residues;
  for (const std::size_t i : kept)
  {
    const NamedAtom& atom = atoms[i];
    const bool isNew = residues.empty() ||
      !InSameResidue(atoms[residues.back().Atoms.front()], atom) ||
      (IsFirstName(atom.Name) && atom.Name == atoms[residues.back().Atoms.front()].Name);
    if (isNew)
    {
      residues.emplace_back();
    }
    residues.back().Atoms.push_back(i);
    NameAtom(atom, i, residues.back());
  }
  for (PolymerResidue& residue : residues)
  {
    CompleteResidue(atoms, residue);
  }
  for (std::size_t r = 0; r + 1 < residues.size(); ++r)
  {
    residues[r].IsLinked = AreLinked(atoms, residues[r], residues[r + 1]);
  }
  return residues;
}

}
