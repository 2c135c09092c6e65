/**
 * @file MultigridPoisson.h
 * @brief One multigrid cycle for -div(eps grad z) + d z = r on a box, as a preconditioner.
 *
 * The operator is the symmetric 7-point one with a permittivity on each edge and z = 0 on the
 * border. A cycle V(1,1) smooths by red-black Gauss-Seidel, restricts by full weighting and
 * prolongs trilinearly. Coarse permittivities are computed from the finer ones: harmonic mean along
 * the edge, 1/4 1/2 1/4 across it. Axes whose spacing is more than 1.5 times the shortest are not
 * coarsened until the spacings are similar. Any number of nodes along an axis is allowed, since a
 * coarse grid may reach half a cell beyond the border; a cycle reduces the residual to a fifth with
 * 2^k + 1 nodes, and to half with other numbers. All numbers are float, which is sufficient for a
 * preconditioner and reduces memory traffic, which dominates the cost.
 *
 * A. Brandt, Math. Comp. 31 (1977) 333; U. Trottenberg, C. Oosterlee, A. Schueller, Multigrid
 * (2001).
 */
#ifndef isthmus_MultigridPoisson_h
#define isthmus_MultigridPoisson_h

#include "vtkIsthmusFiltersElectrostaticsModule.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace isthmus
{

/**
 * Permittivities by code, so that the finest grid takes three bytes per node: `Code[a][node]` names
 * the permittivity `Table[Code]` of the edge from the node to the next along axis a.
 */
struct EdgePermittivity
{
  std::array<std::vector<unsigned char>, 3> Code;
  std::array<float, 256> Table{};
};

struct MultigridLevel;

/// Memory: 12.6 bytes for each node in addition to the three of the codes, and 4.6 more with a
/// diagonal.
class VTKISTHMUSFILTERSELECTROSTATICS_EXPORT MultigridPoisson
{
public:
  /// `weights` are (h / h_axis)^2, h the shortest spacing.
  MultigridPoisson(const std::array<std::int64_t, 3>& dimensions,
    const std::array<double, 3>& weights, EdgePermittivity permittivity);
  ~MultigridPoisson();
  MultigridPoisson(const MultigridPoisson&) = delete;
  void operator=(const MultigridPoisson&) = delete;

  /// Sets d (times h^2) on the finest grid; empty for none. It is kept, not copied.
  void SetDiagonal(std::shared_ptr<const std::vector<float>> diagonal);

  /// z = one cycle from z = 0 for the right side r. O(nodes): about 60 bytes of traffic a node.
  void Cycle(const std::vector<double>& r, std::vector<float>& z);

  int NumberOfLevels() const;

private:
  void Descend(std::size_t level);

  std::vector<std::unique_ptr<MultigridLevel>> Levels;
};

}

#endif
