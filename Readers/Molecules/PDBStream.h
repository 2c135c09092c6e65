/**
 * @file PDBStream.h
 * @brief The lines of a PDB file as a stream for gemmi, checked and completed.
 */
#ifndef isthmus_PDBStream_h
#define isthmus_PDBStream_h

#include "Core/Progress.h"
#include "Files/TextLines.h"

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace isthmus
{

/// Thrown on a line whose coordinates are not where PDB has them.
struct NonstandardColumnsError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/**
 * A stream for gemmi's PDB parser. Blank occupancies and B factors, of which gemmi would make 1 and
 * 20, are given as the number Blank; references to sequence data bases (DBREF) are left out.
 * @throws NonstandardColumnsError where an atom's coordinates are not finite numbers,
 * std::runtime_error where columns 79-80 are not a charge, both with the line; on a record of a
 * piece that only the whole file can say more of.
 */
class PDBStream
{
public:
  static constexpr float Blank = 1e38F;
  static constexpr const char* BlankText = "1e38";

  /// What the text is of a file. Pieces are those of PDBPieces.h.
  enum class Extent
  {
    Whole,
    WholeWithout73To80, ///< the columns beyond 72 are left out
    Piece,
    LastPiece
  };

  PDBStream(std::string_view text, const std::string& path, Extent extent,
    const ProgressCallback& progress);

  /// Whether a line is an ATOM or HETATM record.
  static bool IsAtom(std::string_view line);

  /// gemmi's contract: at most size - 1 characters, the line end among them; nullptr at the end.
  char* gets(char* to, int size);
  int getc() { return '\n'; }

  /// Pairs of serial numbers of the CONECT records so far.
  const std::vector<std::array<int, 2>>& Bonded() const { return this->Bonds; }

private:
  void CheckPiece(std::string_view line) const;
  void CheckAtom();
  void ReadBonds();

  TextLines Lines;
  Extent Kind;
  std::string Line;
  std::vector<std::array<int, 2>> Bonds;
};

}

#endif
