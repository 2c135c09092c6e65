/**
 * @file SurfaceFlow.h
 * @brief Molecular surfaces by mean curvature flow with the atoms as an obstacle.
 *
 * With phi < 0 inside and the distance d to the atoms' balls,
 *
 *   phi_t = |grad phi| div(grad phi / |grad phi|) - (V / gamma) |grad phi|,
 *   phi <= d at all times,   phi(0) = min_i (|x - x_i| - eta r_i).
 *
 * The converged surface is the minimal molecular surface (P. W. Bates, G. W. Wei, S. Zhao, J.
 * Comput. Chem. 29 (2008) 380), here by signed distances in a narrow band in place of the thesis'
 * steep S (4.2, 5.12): the surface meets the atoms between nodes, which makes it second order in
 * the spacing. With a probe, phi also stays above the signed distance of the solvent-excluded
 * surface: the surface lies between atoms and probe, and regions that the probe can enter stay
 * open.
 */
#ifndef isthmus_SurfaceFlow_h
#define isthmus_SurfaceFlow_h

#include "Core/Progress.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

#include <functional>
#include <vector>

namespace isthmus
{

/// Computes -V / gamma at the nodes of a grid, in 1/angstrom; positive values pull towards the
/// atoms.
using PullField = std::function<void(const FlowGrid& grid, std::vector<float>& pull)>;

/// The field at the start of the flow, from balls of `enlargement` times the radius: ceiling,
/// floor, pull and distances in the band.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT FlowField StartField(const std::vector<Ball>& balls,
  const SurfaceFlowParameters& parameters, double factor, double enlargement, const PullField& pull,
  const ProgressCallback& progress);

/**
 * The grid of the result, and the memory that SurfaceFlow will need, in bytes. Nothing is
 * allocated. Throws std::invalid_argument for parameters out of range, balls that are not finite or
 * not positive.
 */
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT DensityGrid FlowResultGrid(
  const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters, double* bytes = nullptr);

/**
 * The surface around `balls`. Time: O(band nodes) for each step, where the band has about 9 area /
 * spacing^2 nodes, and O(pairs of a ball and a node near it). The number of steps is EvolutionTime
 * / (0.16 spacing^2), or a few hundred with Steady. Throws std::runtime_error when the grid does
 * not fit into memory (before it is allocated) or no node lies inside a ball, and Cancelled.
 */
SurfaceFlowResult SurfaceFlow(const std::vector<Ball>& balls,
  const SurfaceFlowParameters& parameters, const PullField& pull = {},
  const ProgressCallback& progress = {});

}

#endif
