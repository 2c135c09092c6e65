/**
 * @file FlowKernels.h
 * @brief The finite-difference kernels of a surface flow. Lengths in spacings.
 *
 * With central differences of second order (19 points), one explicit step is
 *
 *   phi += lambda [ (phi_y^2 + phi_z^2) phi_xx + ... - 2 (phi_x phi_y phi_xy + ...) ]
 *                 / |grad phi|^2  +  lambda V |grad phi|,   lambda = dt / h^2,
 *
 * kept between floor and ceiling (thesis 2.4, there for S). The speed decreases to zero between 2
 * and 4 spacings from the surface, where redistancing dominates and the clamping of the band would
 * have an effect.
 *
 * Redistancing is phi_tau = sgn(phi) (1 - |grad phi|), with Godunov's choice of one-sided
 * differences, second-order ENO (S. Osher, C.-W. Shu, SIAM J. Numer. Anal. 28 (1991) 907). Nodes
 * next to the surface are set to phi / |grad phi| and held, so that the surface stays where it is
 * (G. Russo, P. Smereka, J. Comput. Phys. 163 (2000) 51).
 */
#ifndef isthmus_FlowKernels_h
#define isthmus_FlowKernels_h

#include <cstdint>

namespace isthmus
{

/// Steps in node index to the next row and plane.
struct FlowStrides
{
  std::int64_t Row;
  std::int64_t Plane;
};

/// The bounds and the forces of one step; Floor and Pull may be null.
struct FlowStep
{
  const float* From;
  float* To;
  const float* Ceiling;
  const float* Floor;
  const float* Pull;
  float Lambda;
};

/// One step of the flow on the nodes [first, last).
void AdvanceRow(const FlowStep& step, FlowStrides strides, std::int64_t first, std::int64_t last);

/// Sets nodes next to the surface to phi / |grad phi| (where `trusted`, to phi) with free = 0;
/// others keep theirs, free = 1.
void HoldSurfaceRow(const float* from, float* to, unsigned char* free, bool trusted,
  FlowStrides strides, std::int64_t first, std::int64_t last);

/// One step of redistancing on the free nodes of [first, last).
void RedistanceRow(const float* from, float* to, const unsigned char* free, FlowStrides strides,
  std::int64_t first, std::int64_t last);

}

#endif
