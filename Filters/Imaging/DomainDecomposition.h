/**
 * @file DomainDecomposition.h
 * @brief The parts of an image on the ranks of a controller: halos, disjoint ownership, sums.
 */
#ifndef isthmus_DomainDecomposition_h
#define isthmus_DomainDecomposition_h

#include "Core/ImageExtent.h"

#include <vector>

class vtkMultiProcessController;

namespace isthmus
{

/**
 * Every rank constructs one from its own extent; then all ranks call the same methods in the same
 * order.
 *
 * Parts may overlap, like those of VTK, which share a layer of nodes; the lowest rank that has a
 * node owns it.
 */
class DomainDecomposition
{
public:
  /// `own` is the part that this rank computes, `halo` the number of nodes it needs around it. With
  /// a null controller, or one with a single process, there is one part.
  /// @throws std::runtime_error, on all ranks, if the parts do not cover the whole or overlap
  /// crosswise.
  DomainDecomposition(
    vtkMultiProcessController* controller, const Extent& whole, const Extent& own, int halo);

  bool Distributed() const { return this->Extents.size() > 1; }

  /// The extent of the arrays: the part of this rank with its halo, clipped to the whole extent.
  const Extent& Local() const { return this->LocalExtent; }

  /// The extent of the whole image.
  const Extent& WholeExtent() const { return this->Whole; }

  /// The extent that this rank owns.
  const Extent& Owned() const { return this->OwnedExtent; }

  /// Fills the halo of an array, whose extent is Local(), from the ranks that have the nodes.
  template <typename T>
  void ExchangeHalo(T* values) const;

  /// Sums over the ranks, in place.
  void Sum(double* values, int count) const;

private:
  void FindOwned();

  /// Nodes of rank `owner` that rank `user` needs; empty for a rank without a halo.
  Extent Shared(std::size_t owner, std::size_t user) const;

  vtkMultiProcessController* Controller;
  Extent Whole;
  int Halo;
  std::size_t Rank = 0;
  std::vector<Extent> Extents; ///< of every rank, without halos
  Extent LocalExtent, OwnedExtent;
};

}

#endif
