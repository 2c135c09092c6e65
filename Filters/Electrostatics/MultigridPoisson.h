/**
 * @file MultigridPoisson.h
 * @brief One multigrid cycle for -div(eps grad z) + d z = r on a box, as a preconditioner.
 *
 * The operator is the symmetric 7-point one with a permittivity on each edge and z = 0 on the
 * border. A cycle V(1,1) smooths by red-black Gauss-Seidel, restricts by full weighting and
 * prolongs trilinearly. Coarse permittivities are made from the finer ones: harmonic mean along the
 * edge, 1/4 1/2 1/4 across it. Axes whose spacing is more than 1.5 times the shortest are left
 * alone until the others have caught up, and any number of nodes along an axis is fine: a coarse
 * grid may reach half a cell beyond the border (a cycle leaves a fifth of the residual on 2^k + 1
 * nodes, half of it on others). All in float: as a preconditioner it needs no more, and memory
 * traffic is what costs.
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
 * Permittivities by code, so that the finest grid takes three bytes a node: `Code[a][node]` names
 * the permittivity `Table[Code]` of the edge from the node to the next along axis a.
 */
struct EdgePermittivity
{
  std::array<std::vector<unsigned char>, 3> Code;
  std::array<float, 256> Table{};
};

struct MultigridLevel;

/// Memory: 12.6 bytes a node beside the codes' three, 4.6 more with a diagonal.
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
