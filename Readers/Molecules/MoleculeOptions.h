/**
 * @file MoleculeOptions.h
 * @brief What MacromoleculeReader is asked for.
 */
#ifndef isthmus_MoleculeOptions_h
#define isthmus_MoleculeOptions_h

#include "Atoms/ChemicalElement.h"

#include <cstdint>
#include <string>

namespace isthmus
{

enum class MoleculeFormat
{
  ByName, ///< from the file's extension (.gz and .bz2 left out), else from its first lines
  PDB,
  MMCIF,
  PQR,
  XYZ
};

/// Which atoms to read, and what to add to them.
struct MoleculeOptions
{
  MoleculeFormat Format = MoleculeFormat::ByName;
  std::int64_t Model = 0; ///< from 0, in the order of the file
  std::string Assembly;   ///< that the file describes, by its name; empty: the file as it is
  std::string Chains;     ///< names between blanks or commas; empty: all
  /// Empty: of each residue the location with the highest occupancy; "*": all; else that letter.
  std::string AltLoc;
  bool Hetero = true; ///< HETATM atoms, water aside
  bool Water = true;
  RadiusTable Radii = RadiusTable::Bondi;
  bool BondsByDistance = true;
};

}

#endif
