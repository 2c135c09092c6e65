/**
 * @file MoleculeOptions.h
 * @brief Which atoms of a file to read, and which data to add to them.
 */
#ifndef isthmus_MoleculeOptions_h
#define isthmus_MoleculeOptions_h

#include "Atoms/AtomRadii.h"
#include "Molecules/MoleculeFormats.h"
#include "vtkIsthmusReadersMoleculesModule.h"

#include <cstdint>
#include <string>

namespace isthmus
{

/// Whether the models of a PDB file are one structure.
enum class ModelCombination
{
  Automatic, ///< where they are copies beside each other, as in a file of a biological unit
  Never,
  Always
};

/// The unit of length of the coordinates in a file.
enum class CoordinateUnit
{
  ByFormat, ///< nanometre in GRO files, else angstrom
  Angstrom,
  Nanometre,
  Bohr
};

/// Which atoms to read, and what to add to them.
struct MoleculeOptions
{
  MoleculeFormat Format = MoleculeFormat::ByName;
  CoordinateUnit LengthUnit = CoordinateUnit::ByFormat;
  std::int64_t ModelIndex = 0; ///< from 0, in the order of the file
  ModelCombination CombineModels = ModelCombination::Automatic;
  std::string Assembly; ///< that the file describes, by its name; empty: the file as it is
  std::string Chains;   ///< names separated by blanks or commas; empty: all
  /// Empty: of each residue the location with the highest occupancy; "*": all; else that letter.
  std::string AltLoc;
  bool ReadHetero = true; ///< HETATM atoms, water aside
  bool ReadWater = true;
  isthmus::RadiusTable RadiusTable = isthmus::RadiusTable::Bondi;
  bool BondsByDistance = true;
};

/// @throws std::invalid_argument with property, value and range.
VTKISTHMUSREADERSMOLECULES_EXPORT void Check(const MoleculeOptions& options);

}

#endif
