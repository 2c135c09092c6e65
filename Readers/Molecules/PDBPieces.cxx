#include "Molecules/PDBPieces.h"

#include "Core/ParallelFor.h"
#include "Molecules/GemmiAtom.h"
#include "Molecules/PDBStream.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <unordered_map>

#include <gemmi/pdb.hpp>

namespace isthmus
{
namespace
{

struct Piece
{
  std::string_view Text;
  gemmi::Structure Structure;
  std::vector<std::array<int, 2>> Bonded;
};

/// Pieces that begin with an atom, so that what a record says of the atom before it stays with it.
std::vector<Piece> Cut(std::string_view text, std::size_t bytesOfAPiece)
{
  std::vector<Piece> pieces;
  std::size_t begin = 0;
  for (std::size_t at = 0; begin < text.size();)
  {
    at = std::min(text.find('\n', std::max(at, begin + bytesOfAPiece)), text.size());
    at += at < text.size() ? 1 : 0;
    if (at == text.size() || PDBStream::IsAtom(text.substr(at, 80)))
    {
      pieces.emplace_back();
      pieces.back().Text = text.substr(begin, at - begin);
      begin = at;
    }
  }
  return pieces;
}

void Read(Piece& piece, bool isLast, const std::string& path)
{
  PDBStream stream(
    piece.Text, path, isLast ? PDBStream::Extent::LastPiece : PDBStream::Extent::Piece, {});
  piece.Structure = gemmi::pdb_impl::read_pdb_from_stream(stream, path, gemmi::PdbReadOptions());
  piece.Bonded = stream.Bonded();
}

/// What one piece has of a residue, and where its atoms go.
struct Part
{
  const gemmi::Residue* Residue;
  std::size_t Number; ///< of the whole residue
  std::size_t Place;  ///< of its first atom
};

struct WholeResidue
{
  const gemmi::Chain* Chain;
  const gemmi::Residue* First; ///< the part that names it
  std::size_t Atoms;
};

struct HashOfResidue
{
  std::size_t operator()(const gemmi::Residue* residue) const
  {
    const std::size_t number = residue->seqid.num.has_value()
      ? static_cast<std::size_t>(static_cast<std::uint32_t>(*residue->seqid.num))
      : 0;
    return number * 0x9E3779B97F4A7C15u ^ std::hash<std::string>()(residue->name);
  }
};

struct SameResidue
{
  bool operator()(const gemmi::Residue* a, const gemmi::Residue* b) const { return a->matches(*b); }
};

class Joiner
{
public:
  explicit Joiner(const std::vector<Piece>& pieces)
  {
    for (const Piece& piece : pieces)
    {
      for (const gemmi::Chain& chain : piece.Structure.first_model().chains)
      {
        this->Add(chain);
      }
    }
    std::vector<std::size_t> place;
    for (const WholeResidue& residue : this->Residues)
    {
      place.push_back(this->Atoms);
      this->Atoms += residue.Atoms;
    }
    for (Part& part : this->Parts)
    {
      part.Place = place[part.Number];
      place[part.Number] += part.Residue->atoms.size();
    }
  }

  std::vector<Atom> Flatten() const
  {
    std::vector<Atom> atoms;
    atoms.reserve(this->Atoms);
    atoms.resize(this->Atoms);
    constexpr std::int64_t partsAtOnce = 256;
    ParallelFor(0, static_cast<std::int64_t>(this->Parts.size()), partsAtOnce,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t p = first; p < last; ++p)
        {
          const Part& part = this->Parts[static_cast<std::size_t>(p)];
          const WholeResidue& whole = this->Residues[part.Number];
          Atom* to = atoms.data() + part.Place;
          for (const gemmi::Atom& atom : part.Residue->atoms)
          {
            Assign(*to++, *whole.Chain, *whole.First, atom);
          }
        }
      });
    return atoms;
  }

private:
  /// gemmi begins a chain where the name changes, and so do we between pieces.
  void Add(const gemmi::Chain& chain)
  {
    if (!this->Current || this->Current->name != chain.name)
    {
      this->Current = &chain;
      this->Known.clear();
    }
    for (const gemmi::Residue& residue : chain.residues)
    {
      const auto [found, fresh] = this->Known.emplace(&residue, this->Residues.size());
      if (fresh)
      {
        this->Residues.push_back({ this->Current, &residue, 0 });
      }
      this->Residues[found->second].Atoms += residue.atoms.size();
      this->Parts.push_back({ &residue, found->second, 0 });
    }
  }

  const gemmi::Chain* Current = nullptr;
  std::unordered_map<const gemmi::Residue*, std::size_t, HashOfResidue, SameResidue> Known;
  std::vector<WholeResidue> Residues;
  std::vector<Part> Parts;
  std::size_t Atoms = 0;
};

template <typename Work>
void ForEach(std::vector<Piece>& pieces, Work&& work, const ProgressCallback& progress = {})
{
  ParallelFor(
    0, static_cast<std::int64_t>(pieces.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto p = static_cast<std::size_t>(first); p < static_cast<std::size_t>(last); ++p)
      {
        work(pieces[p]);
      }
    },
    progress);
}

}

std::optional<JoinedPDB> ReadPDBInPieces(std::string_view text, const std::string& path,
  std::size_t bytesOfAPiece, const ProgressCallback& progress)
{
  std::vector<Piece> pieces = Cut(text, bytesOfAPiece);
  if (pieces.size() < 2)
  {
    return {};
  }
  try
  {
    ForEach(
      pieces, [&](Piece& piece) { Read(piece, &piece == &pieces.back(), path); }, progress);
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::exception&)
  {
    return {}; // reading it whole finds the same, and its line
  }
  JoinedPDB joined;
  joined.Molecule.NumberOfModels = 1;
  joined.Molecule.Atoms = Joiner(pieces).Flatten();
  for (const Piece& piece : pieces)
  {
    joined.Bonded.insert(joined.Bonded.end(), piece.Bonded.begin(), piece.Bonded.end());
  }
  ForEach(pieces, [](Piece& piece) { piece.Structure = gemmi::Structure(); });
  return joined;
}

}
