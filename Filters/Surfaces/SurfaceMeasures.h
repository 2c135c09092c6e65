/**
 * @file SurfaceMeasures.h
 * @brief Area, enclosed volume and topology of a triangle surface, in total and for each component.
 *
 *     area    = sum over triangles (v_i, v_j, v_k) of |(v_j - v_i) x (v_k - v_i)| / 2
 *     volume  = 1/3 closed integral of x . n dA = sum of v_i . (v_j x v_k) / 6
 *     Euler   = points - edges + triangles
 *     genus   = sum over components of (2 - Euler - boundary loops) / 2
 *
 * Sources: X. Feng's thesis, 4.40 and 4.41 (which lack the factor 1/3 and have the factors of the
 * cross product in the order that gives minus the volume). The volume is positive where triangles
 * are counter-clockwise seen from outside, and negative for a surface turned inside out. For shells
 * with cavities it is the volume between them, if the triangles of the cavities face the cavities.
 */
#ifndef isthmus_SurfaceMeasures_h
#define isthmus_SurfaceMeasures_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h" // for the export macro

#include <string>
#include <vector>

namespace isthmus
{

/// Measures of one component, or of all together.
struct SurfaceMeasure
{
  double Area = 0.0;        ///< length^2
  double Volume = 0.0;      ///< length^3; not a number unless OpenEdges is 0
  double AreaError = 0.0;   ///< estimates for a mesh of a smooth surface (ChordError.h)
  double VolumeError = 0.0; ///< as Volume
  vtkIdType Points = 0;     ///< those that triangles use
  vtkIdType Edges = 0;
  vtkIdType Triangles = 0;
  vtkIdType OpenEdges = 0; ///< with more triangles on one side than on the other: holes, flipped
                           ///< neighbours
  vtkIdType BoundaryLoops = 0;   ///< holes of the surface
  vtkIdType IrregularPoints = 0; ///< around which the surface is neither a disc nor a half disc
  vtkIdType Genus = 0;           ///< handles, holes closed; -1 if IrregularPoints is not 0

  vtkIdType EulerNumber() const { return this->Points - this->Edges + this->Triangles; }
  bool IsClosed() const { return this->OpenEdges == 0; }
};

struct SurfaceMeasures
{
  SurfaceMeasure Whole;
  std::vector<SurfaceMeasure> Components; ///< in the order of their first points
};

/**
 * Measures `mesh`. Triangles that share a point belong to one component.
 *
 * Degenerate triangles (without area, or with the same corner twice) are allowed; the latter make
 * their corners irregular. Time O(triangles), memory about 150 bytes per triangle.
 * @throws Cancelled.
 */
SurfaceMeasures MeasureSurface(const SurfaceView& mesh, const ProgressCallback& progress = {});

/**
 * A sentence for the message of a repair if it changed the number of components or the genus:
 * "Repair changed the genus from 8 to 7." Empty if it did not, or if one of the surfaces has no
 * genus (IrregularPoints). Of surfaces without invalid triangles. O(triangles).
 */
VTKISTHMUSFILTERSSURFACES_EXPORT std::string DescribeTopologyChange(
  const SurfaceView& before, const SurfaceView& after);

}

#endif
