/**
 * @file MultigridLevel.h
 * @brief One grid of MultigridPoisson and what is done on it.
 */
#ifndef isthmus_MultigridLevel_h
#define isthmus_MultigridLevel_h

#include "Electrostatics/EdgePermittivity.h"

#include <cstdint>
#include <memory>

namespace isthmus
{

/// The finest level holds codes, the others permittivities (times weight and scale) as they are.
struct MultigridLevel
{
  std::array<std::int64_t, 3> Dimensions;
  std::array<float, 3> Weight;            ///< (h_finest / h_axis)^2 of this level
  EdgePermittivity Coded;                 ///< finest level
  std::array<std::vector<float>, 3> Edge; ///< coarser levels, weights included
  /// Finest level: for each line along x, the one permittivity of all edges it meets, or 0.
  std::vector<float> LinePermittivity;
  std::shared_ptr<const std::vector<float>> Diagonal;
  std::array<bool, 3> Halved{ false, false, false }; ///< axes that the next level halves
  std::vector<float> X, B;

  std::int64_t Size() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }
  bool Finest() const { return this->Edge[0].empty(); }
};

/// Finds lines with one permittivity only.
void ClassifyLines(MultigridLevel& level);

/// Whether there is a coarser level: chooses the axes to halve.
bool ChooseCoarsening(MultigridLevel& level);

/// The next level, without diagonal.
std::unique_ptr<MultigridLevel> Coarsen(const MultigridLevel& fine);

/// The fine diagonal, averaged to the coarse level.
std::shared_ptr<const std::vector<float>> CoarsenDiagonal(
  const MultigridLevel& fine, const MultigridLevel& coarse);

/// One Gauss-Seidel sweep over the nodes with (i + j + k) % 2 == colour.
void SmoothColour(MultigridLevel& level, int colour);

/// Restricts the residual B - A X of `fine` to B of `coarse`.
void RestrictResidual(const MultigridLevel& fine, MultigridLevel& coarse);

/// Adds the correction X of `coarse`, interpolated, to X of `fine`.
void AddCorrection(const MultigridLevel& coarse, MultigridLevel& fine);

}

#endif
