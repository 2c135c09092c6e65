/**
 * @file BinaryCIF.h
 * @brief BinaryCIF files as documents of CIF.
 *
 * The format (D. Sehnal et al., PLoS Comput. Biol. 16 (2020) e1008247;
 * https://github.com/molstar/BinaryCIF, version 0.3) is a MessagePack map with columns that are
 * encoded in several steps: ByteArray, FixedPoint, IntervalQuantization, RunLength, Delta,
 * IntegerPacking and StringArray, with masks for values that are not present ('.') or unknown
 * ('?'). MessagePack is read by nlohmann-json.
 */
#ifndef isthmus_BinaryCIF_h
#define isthmus_BinaryCIF_h

#include <functional>
#include <string>
#include <string_view>

#include <gemmi/cifdoc.hpp>

namespace isthmus
{

/// Whether it is a MessagePack map with the keys of BinaryCIF.
bool IsBinaryCIF(std::string_view bytes);

/**
 * The data blocks with the categories for which `isWanted("_atom_site.")` holds, as if they were
 * read from text: numbers have the shortest decimals that give the same number. O(bytes).
 * @throws std::invalid_argument for a damaged file, with category and column.
 */
gemmi::cif::Document ReadBinaryCIF(
  std::string_view bytes, const std::function<bool(const std::string&)>& isWanted);

}

#endif
