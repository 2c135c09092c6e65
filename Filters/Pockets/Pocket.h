/**
 * @file Pocket.h
 * @brief Pockets of a molecule: parameters and result.
 */
#ifndef isthmus_Pocket_h
#define isthmus_Pocket_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersPocketsModule.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

namespace isthmus
{

struct SiteAtom;

/// Lengths in angstrom.
struct PocketOptions
{
  double ProbeRadius =
    1.4; ///< of water: volumes and areas are of the region that its center can reach
  double InnerRadius = 1.7; ///< of a ball that fits into a pocket: a united-atom carbon
  double OuterRadius = 3.1; ///< of a ball that does not fit into a pocket
  double BurialRadius = 10.0;
  double MinimumVolume = 10.0; ///< angstrom^3; smaller pockets are dropped
  /// The heavy atoms with their properties for binding (SiteDescriptors.h): pockets are then
  /// divided into sites of the size of a ligand, ranked by their probability. Null: whole pockets,
  /// ranked by Score.
  const std::vector<SiteAtom>* SiteAtoms = nullptr;
  bool KeepDescriptors = false; ///< SitePlace::Descriptors
  /// The three vectors of a periodic cell, of which the atoms are the whole content; empty: none.
  /// A pocket is then space that the outer ball does not reach from infinitely far, and there are
  /// no sites, since the model knows nothing of neighbours in a crystal.
  std::vector<Point3> Cell;
  /// Called with the predicted time of the triangulation in seconds (RegularFiltration.h).
  std::function<void(double)> Predicted;
};

/// @throws std::invalid_argument with property, value and range.
VTKISTHMUSFILTERSPOCKETS_EXPORT void Check(const PocketOptions& options);

/// An opening through which a ball can leave a pocket.
struct PocketMouth
{
  double Radius = 0.0;                                ///< of the largest ball that passes
  double Area = 0.0;                                  ///< area accessible to the probe's center
  std::vector<std::array<std::int64_t, 3>> Triangles; ///< of atoms
  std::vector<double> Clearance;                      ///< one for each triangle
};

/// A tetrahedron of a pocket.
struct PocketCell
{
  std::array<std::int64_t, 4> Atoms;
  Point3 Center; ///< of the sphere that is orthogonal to the four atoms enlarged by the probe
  double Clearance = 0.0;  ///< radius of the largest ball there that touches no atom
  double Access = 0.0;     ///< radius of the largest ball that gets there from outside
  double Volume = 0.0;     ///< empty volume; only sums over voids are meaningful (EmptySpace.h)
  std::int64_t Burial = 0; ///< number of atoms within BurialRadius of Center
  double Size = 0.0;       ///< volume of the tetrahedron
  bool IsFlat = false; ///< its center may lie anywhere, at a flat side of the hull even far outside
  double SiteProbability = 0.0; ///< probability that a ligand's atom is near its center
};

struct LiningAtom
{
  std::int64_t Atom;
  double Area; ///< area of its surface that faces the pocket
};

/// A pocket, or one of the sites into which it is divided.
struct Pocket
{
  double Score = 0.0;
  double Probability = std::numeric_limits<double>::quiet_NaN(); ///< of a site: SiteModel.h
  double Density = std::numeric_limits<double>::quiet_NaN();     ///< of a site: PocketSites.h
  std::int64_t Parent =
    0; ///< of a site: its pocket, numbered from 1 by the rank of the best site in it; 0: none
  std::int64_t Group = 0;         ///< of a site: number shared with its copies (SiteCopies.h)
  int Chain = -1;                 ///< of a site: the nearest chain
  double Volume = 0.0;            ///< of a site: PocketScore.h
  double Area = 0.0;              ///< of a site: the sum over its lining
  double Radius = 0.0;            ///< the largest clearance
  double Access = 0.0;            ///< the largest access radius
  Point3 Center{ 0.0, 0.0, 0.0 }; ///< of a site: the mode of its density
  std::vector<PocketCell> Cells;
  std::vector<PocketMouth> Mouths; ///< the widest first; a void has none
  std::vector<LiningAtom> Lining;  ///< in the order of the atoms
};

/// A place evaluated by the site model.
struct SitePlace
{
  Point3 Center{ 0.0, 0.0, 0.0 };
  double Probability = 0.0;       ///< probability that a ligand's atom is within 3 angstrom
  std::vector<float> Descriptors; ///< from which it was computed, if kept
};

struct PocketResult
{
  std::vector<Pocket> Pockets;       ///< or sites; the best first
  std::vector<SitePlace> SitePlaces; ///< all places, if there are sites
  /// In a periodic cell the numbers of atoms in the pockets refer to these copies of them.
  std::vector<Point3> Copies;
  std::vector<std::int64_t> CopyAtoms; ///< of each copy: its atom
  double UnionVolume = 0.0;            ///< volume of all atoms enlarged by the probe
  double UnionArea = 0.0;              ///< accessible surface of all atoms
  double PocketVolume = 0.0; ///< volume of all pockets, including those dropped as too small
  double RestVolume = 0.0;   ///< empty volume of the convex hull outside of all pockets
  double HullVolume = 0.0;   ///< total volume of the tetrahedra
  double FullVolume = 0.0;   ///< volume of the hull inside the enlarged atoms
};

}

#endif
