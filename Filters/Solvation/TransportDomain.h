/**
 * @file TransportDomain.h
 * @brief Where a channel, its membrane and its baths lie on a grid, and how far nodes are from
 * atoms.
 *
 * A cylinder around the channel's axis holds all atoms and some more on all sides. The grid is the
 * box around it, with a node in the membrane's centre and a layer of nodes beyond the cylinder.
 */
#ifndef isthmus_TransportDomain_h
#define isthmus_TransportDomain_h

#include "Atoms/Ball.h"
#include "Core/Progress.h"
#include "Solvation/IonTransportParameters.h"
#include "vtkIsthmusFiltersSolvationModule.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Where the domain lies, before anything is computed on it.
struct TransportDomain
{
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  Point3 Origin{ 0.0, 0.0, 0.0 };
  double Spacing = 1.0;
  Point3 Centre{ 0.0, 0.0, 0.0 };
  Point3 Normal{ 0.0, 0.0, 1.0 }; ///< of length 1
  double Radius = 0.0;            ///< of the cylinder
  double HalfLength = 0.0;        ///< from the centre to the baths, whole spacings

  std::int64_t Size() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }
  std::array<std::int64_t, 3> Steps() const
  {
    return { 1, this->Dimensions[0], this->Dimensions[0] * this->Dimensions[1] };
  }
  std::array<std::int64_t, 3> Indices(std::int64_t node) const
  {
    const auto& n = this->Dimensions;
    return { node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
  }
  Point3 Place(std::int64_t node) const
  {
    const std::array<std::int64_t, 3> at = this->Indices(node);
    return { this->Origin[0] + this->Spacing * static_cast<double>(at[0]),
      this->Origin[1] + this->Spacing * static_cast<double>(at[1]),
      this->Origin[2] + this->Spacing * static_cast<double>(at[2]) };
  }
  /// How far along the axis a place is, from the membrane's centre, and how far from the axis.
  std::array<double, 2> AlongAndOff(const Point3& place) const;
};

/// @throws std::invalid_argument for parameters out of range, std::runtime_error with the size
/// where the memory for it is not there.
VTKISTHMUSFILTERSSOLVATION_EXPORT TransportDomain DomainAround(
  const std::vector<Ball>& atoms, const IonTransportParameters& parameters);

/// @throws std::runtime_error with the domain's size where so many bytes a node are not there.
VTKISTHMUSFILTERSSOLVATION_EXPORT void RequireMemory(
  const TransportDomain& domain, double bytesPerNode);

/// The distance from each node to the solvent-excluded surface of atoms
/// (SolventExcludedSurface.h), or for ProbeRadius 0 to the atoms; angstrom, negative within, cut
/// at 4.5 spacings. Parallel.
/// @throws Cancelled.
VTKISTHMUSFILTERSSOLVATION_EXPORT std::vector<float> DistanceToAtoms(const TransportDomain& domain,
  const std::vector<Ball>& atoms, double probeRadius, const ProgressCallback& progress = {});

}

#endif
