/**
 * @file Macromolecule.h
 * @brief Atoms and bonds of a molecule file, and the options for reading one.
 */
#ifndef isthmus_Macromolecule_h
#define isthmus_Macromolecule_h

#include "Molecules/MoleculeOptions.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace isthmus
{

/// One atom. Data that a file lacks are NaN, 0 or empty, as stated for each member.
struct Atom
{
  static constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

  std::array<double, 3> Position{ 0.0, 0.0, 0.0 }; ///< angstrom
  double Radius = Unknown;                         ///< angstrom
  double Charge = Unknown;                         ///< e
  double BFactor = Unknown;                        ///< angstrom^2
  double Occupancy = Unknown;
  double PLDDT = Unknown;  ///< confidence of a predicted residue, 0 to 100
  std::string Name;        ///< "CA"
  std::string ResidueName; ///< "LYS"
  std::string Chain;       ///< the authors' name, empty if none
  int ResidueId = 0;       ///< the authors' number
  int Serial = 0;          ///< number in the file
  int Element = 0;         ///< atomic number, 0: unknown
  char InsertionCode = ' ';
  char AltLoc = ' '; ///< alternate location, blank: the only one
  bool IsHetero = false;
  /// Secondary structure that the file gives: 0 coil, 1 alpha helix, 2 strand, 3 3-10 helix, 4 pi
  /// helix.
  static constexpr unsigned char NoStructure = 255;
  unsigned char Structure = NoStructure;
};

/// A bond between two atoms, given by their indices in the list of atoms; First < Second.
struct Bond
{
  std::int64_t First;
  std::int64_t Second;
  bool FromFile; ///< given by the file; otherwise found by distance
};

/// One model of a file. Notes are for reference, warnings are shown to the user.
struct Macromolecule
{
  std::vector<Atom> Atoms;
  std::vector<Bond> Bonds;
  std::int64_t NumberOfModels = 0; ///< in the file
  /// The three vectors of the periodic cell, angstrom; empty if the file has none.
  std::vector<std::array<double, 3>> Cell;
  std::string SpaceGroup;    ///< Hermann-Mauguin symbol that the file gives; empty: none
  bool MayBeBroken = true;   ///< at the periodic box, as simulation programs write molecules
  double UnitOfFormat = 1.0; ///< the format's unit of length, angstrom
  std::vector<std::string> Notes;
  std::vector<std::string> Warnings;
};

/// "FE of HEM 142 A", for messages.
inline std::string Describe(const Atom& atom)
{
  if (atom.ResidueName.empty())
  {
    return atom.Name;
  }
  std::string text = atom.Name + " of " + atom.ResidueName + " " + std::to_string(atom.ResidueId);
  if (atom.InsertionCode != ' ')
  {
    text += atom.InsertionCode;
  }
  return atom.Chain.empty() ? text : text + " " + atom.Chain;
}

}

#endif
