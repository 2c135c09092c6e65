/**
 * @file GemmiAtom.h
 * @brief Converts one atom of gemmi.
 */
#ifndef isthmus_GemmiAtom_h
#define isthmus_GemmiAtom_h

#include "Molecules/Macromolecule.h"

#include <gemmi/model.hpp>

#include <cmath>

namespace isthmus
{

/// Values passed to gemmi for unknown occupancies and B factors, for which it would otherwise use 1
/// and 20.
constexpr float BlankNumber = 1e38F;
constexpr const char* BlankText = "1e38";

inline double NaNIfUnknown(float value)
{
  return value == BlankNumber ? Atom::Unknown : static_cast<double>(value);
}

/// Rounds values that gemmi stores as floats, so that 0.7 becomes 0.7 in double.
inline double Decimal(float value)
{
  const double known = NaNIfUnknown(value);
  const double rounded = std::round(known * 1e5) / 1e5;
  return static_cast<float>(rounded) == value ? rounded : known;
}

inline void Assign(
  Atom& to, const gemmi::Chain& chain, const gemmi::Residue& residue, const gemmi::Atom& from)
{
  to.Position = { from.pos.x, from.pos.y, from.pos.z };
  to.Charge = from.charge == 0 ? Atom::Unknown : from.charge;
  to.BFactor = Decimal(from.b_iso);
  to.Occupancy = Decimal(from.occ);
  to.Name = from.name;
  to.ResidueName = residue.name;
  to.Chain = chain.name;
  to.ResidueId = residue.seqid.num.has_value() ? *residue.seqid.num : 0;
  to.Serial = from.serial;
  to.Element = from.element == gemmi::El::D ? 1 : from.element.ordinal();
  to.InsertionCode = residue.seqid.icode;
  to.AltLoc = from.altloc_or(' ');
  to.IsHetero = residue.het_flag == 'H';
}

}

#endif
