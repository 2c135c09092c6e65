/**
 * @file ThesisFlow.h
 * @brief The minimal molecular surface by the scheme printed in the thesis.
 *
 * S is 1 in the union of the enlarged balls and 0 elsewhere, and flows by
 *
 *   S_t = (1 - chi) [ (S_x^2 + S_y^2) S_zz + ... - 2 (S_x S_y S_xy + ...) ] / |grad S|^2,
 *
 * chi = 1 in the balls, S = 0 on the border of the box (thesis 4.2, 5.11 to 5.14 and the expanded
 * form after 5.14, misprints corrected), dt = 0.1 spacing^2. It is included for comparison: because
 * of the jump of S and the steps of chi, the surface converges outside the correct position, with
 * order 1/2 in the spacing.
 */
#ifndef isthmus_ThesisFlow_h
#define isthmus_ThesisFlow_h

#include "Core/Progress.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"

#include <vector>

namespace isthmus
{

/// The surface S = 0.5 around `balls`; ProbeRadius and CoarseToFine are not used. Time: O(nodes)
/// for each step. Throws as SurfaceFlow does.
SurfaceFlowResult ThesisFlow(const std::vector<Ball>& balls,
  const SurfaceFlowParameters& parameters, const ProgressCallback& progress = {});

}

#endif
