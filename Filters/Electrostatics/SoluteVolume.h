/**
 * @file SoluteVolume.h
 * @brief Prepares the surface of a solute, given as an image, closed polygons or atoms, for the
 * solver.
 */
#ifndef isthmus_SoluteVolume_h
#define isthmus_SoluteVolume_h

#include "Core/Progress.h"
#include "Electrostatics/LevelFunction.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

namespace isthmus
{

/// A volume (Grid has only its geometry, no arrays) and its level.
struct SoluteVolume
{
  vtkSmartPointer<vtkImageData> Grid;
  LevelFunction Level;
  std::string Kind; ///< what the surface is, in words
  /// Whether the values jump at the level, as those of a mask, so that its place between the nodes
  /// is unknown.
  bool IsMask = false;
  double Decay = 0.0; ///< decay of the atoms' Gaussians, if it is their level; 0 for other surfaces
  std::vector<float> Floats;
  std::vector<double> Doubles;
  vtkSmartPointer<vtkDataArray> Scalars; ///< kept alive
};

/// Memory of a solution, for each node of the grid, with a margin.
constexpr double SolutionBytesPerNode = 130.0;

/// The grids for VolumeFromSurface and VolumeFromAtoms. Throws std::invalid_argument.
vtkSmartPointer<vtkImageData> GridAroundSurface(vtkPolyData* surface, const GridRequest& request);
vtkSmartPointer<vtkImageData> GridAroundAtoms(
  const std::vector<ChargedAtom>& atoms, const GridRequest& request);

/**
 * An image's level. Values that are cut off near the surface (masks, clamped distances) are
 * replaced by the distance from the triangles of the level. Scalars are replaced by their logarithm
 * if that is the more linear function. Throws std::invalid_argument for values that are not finite.
 */
SoluteVolume VolumeFromImage(vtkImageData* image, vtkDataArray* scalars, double level,
  bool insideIsHigher, const ProgressCallback& progress = {});

/// The signed distance from closed triangles. Throws std::invalid_argument if they are not closed.
SoluteVolume VolumeFromSurface(
  vtkPolyData* surface, const GridRequest& request, const ProgressCallback& progress = {});

/// Level 1 of the sum of Gaussians of MolecularDensity.h with decay 2.3, on the nodes of `grid`.
SoluteVolume VolumeFromAtoms(
  const std::vector<ChargedAtom>& atoms, vtkImageData* grid, const ProgressCallback& progress = {});

/// Converts world coordinates to lengths along the axes of the grid from its first node, and back.
Point3 ToGrid(vtkImageData* grid, const Point3& world);
Point3 ToWorld(vtkImageData* grid, const Point3& place);

}

#endif
