/**
 * @file OpenDXObjects.h
 * @brief The objects of an OpenDX file that describe a grid and an array of values.
 */
#ifndef isthmus_OpenDXObjects_h
#define isthmus_OpenDXObjects_h

#include "Files/TextWords.h"
#include "Files/VoxelLattice.h"

#include <cstdint>
#include <string>

namespace isthmus
{

/// One array of a file: its values follow in the file.
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

/**
 * The grid of an object of class `gridpositions`, whose class has just been read: counts, origin (0
 * where there is none), three rows of delta. Reads one word further, into `word`.
 * @throws ReaderError, with the line, unless all are finite and the deltas span a volume.
 */
VoxelLattice ReadOpenDXPositions(TextWords& text, std::string& word);

/**
 * What an object of class `array` says before its values, up to the word `follows`, which is left
 * in `word`. Whether it fits the grid is not looked at.
 * @throws ReaderError, with the line, for types and forms that are not read.
 */
OpenDXArray ReadOpenDXArray(TextWords& text, std::string& word);

}

#endif
