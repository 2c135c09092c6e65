/**
 * @file OpenDXReader.h
 * @brief Reads scalars on a regular grid from an OpenDX file, the format in which APBS and other
 * programs write potentials.
 *
 * The native form of OpenDX (OpenDX User's Reference, appendix B.2), of which these files use
 * objects of class `gridpositions` (counts, origin, three delta rows), `gridconnections`, `array`
 * (type, rank 0 or 1, items, then the values, z fastest) and `field`; attributes; comments from #
 * to the end of a line. Values are text or, after `binary`, `ieee`, `lsb` or `msb`, raw bytes.
 */
#ifndef isthmus_OpenDXReader_h
#define isthmus_OpenDXReader_h

#include "Files/ByteSource.h"
#include "Files/TextWords.h"
#include "Files/VoxelLattice.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace isthmus
{

/// One array of a file, whose values follow in the file.
struct OpenDXArray
{
  bool Single = false; ///< float; all other types come as double
  int Components = 1;
  std::int64_t Items = 0;
  bool Binary = false;
  bool Swap = false;         ///< bytes not in this machine's order
  std::size_t ItemBytes = 8; ///< of one binary number
  bool Whole = false;        ///< binary whole numbers
  bool Unsigned = false;     ///< of these: without a sign
};

/// A file opened at one of its arrays.
/// @throws ReaderError throughout; messages name file and line.
class OpenDXReader
{
public:
  /// Opens the file and moves to the values of array `index`, counted from 0.
  OpenDXReader(const std::string& path, int index, const ProgressCallback& progress = {});

  /// Grid of the array: the last gridpositions before it. Its steps need not be orthogonal.
  const VoxelLattice& Lattice() const { return this->Grid; }
  const OpenDXArray& Array() const { return this->Values; }

  /**
   * Reads the values of the nodes of `box` into `out`, with x varying fastest; T is float or
   * double. Time: one pass over the text. Memory: a few grid planes of constant x.
   */
  template <typename T>
  void Read(const NodeBox& box, T* out, const ProgressCallback& progress);

  /// Checks the text after the values, when Read has finished; additional values are an error.
  void ReadRest();

  /// Name of the field that follows the array; available after ReadRest, may be empty.
  const std::string& FieldName() const { return this->Name; }
  const std::vector<std::string>& Comments() const { return this->Text.Comments(); }
  std::string Compression() const { return this->Source->Compression(); }

private:
  bool NextArray();
  void ReadObject();
  void CheckArray() const;
  void CheckField();
  void CheckPromisedSize(const ProgressCallback& progress);
  void SkipValues(const ProgressCallback& progress);
  template <typename T>
  void ReadNumbers(T* values, std::int64_t count);

  std::unique_ptr<ByteSource> Source;
  TextWords Text;
  VoxelLattice Grid;
  bool HasGrid = false;
  OpenDXArray Values;
  std::string Word; ///< read ahead
  std::string ObjectName;
  std::string GridName;  ///< of the gridpositions read last
  std::string ArrayName; ///< of the array read last
  std::string Name;
};

/// Whether the first word of the file after comments is "object". Never throws.
bool LooksLikeOpenDXFile(const std::string& path);

}

#endif
