/**
 * @class   vtkSurfaceCurvature
 * @brief   Computes curvature at the points of a surface mesh, by angle defect and cotangents, by
 * edges, or by a fit of normals.
 *
 * The input, a vtkPolyData, is passed on with curvature arrays on its points. Polygons and strips
 * are split into triangles for the computation (the cells of the output are unchanged); vertices
 * and lines are ignored.
 *
 * **Arrays**, on points, double, with the same names and signs as in vtkHessianCurvature: those of
 * OutputArrayTable() that GetOutputArraySelection() has, by default `GaussianCurvature`,
 * `MeanCurvature`, `MaximumCurvature`, `MinimumCurvature`, `ShapeIndex`, `Curvedness` and
 * `PointArea`, the area assigned to a point by DualArea, the weight for means over the surface; the
 * sum over all points is the area of the surface. Principal directions, `NormalCurvature` and the
 * differential forms except `GaussMap` are not made with AngleDefect. Field data
 * `GaussianCurvatureIntegral` and `GaussBonnetEulerNumber` (GaussBonnet.h).
 *
 * **Validity.** `CurvatureValid` is 1 where the values are meaningful. It is 0, and all values
 * except `PointArea` are 0, at points on the boundary (with Ball, GeodesicDisc and NormalFit these
 * are valid, but one-sided, with an error of the order of edge length / Radius), at points without
 * triangles, at points around which the surface is not a disc or not consistently oriented, at
 * triangles without area, and where obtuse triangles make the Voronoi area negative (choose Mixed).
 * A warning counts such points, except those on the boundary. Coinciding points are treated as one
 * (SurfaceCleaning.h), so a file with texture coordinates or normals at corners has no boundary at
 * its seams; `PointArea` is divided among them.
 *
 * **Sign.** A sphere has positive curvature, 1/r. Which side is outside is chosen by Orientation.
 *
 * **Method**: formulas and sources are in SurfaceCurvature.h. AngleDefect is of second order on
 * meshes that are regular in some parametrisation. On irregular meshes it does not converge: use
 * NormalFit or, for isosurfaces of a volume, vtkHessianCurvature.
 *
 * **Errors** (one message, empty output): coordinates that are not finite, damaged cells, negative
 * Radius or tolerance. An empty surface is not an error.
 *
 * **Cost.** O(triangles), for balls and discs times the number of triangles within Radius; in
 * parallel, bitwise the same on any number of threads. Memory: about 300 bytes per point with all
 * arrays. With several MPI ranks, each processes its own piece, whose rim is then a boundary, so
 * gather the surface first (in ParaView: Aggregate Dataset).
 */
#ifndef vtkSurfaceCurvature_h
#define vtkSurfaceCurvature_h

#include "Curvature/CurvatureArrays.h"
#include "Curvature/SurfaceCurvature.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKISTHMUSFILTERSCURVATURE_EXPORT vtkSurfaceCurvature : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceCurvature* New();
  vtkTypeMacro(vtkSurfaceCurvature, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    AngleDefect = 0,
    EdgeTensor = 1,
    NormalFit = 2
  };
  enum DualAreas
  {
    Voronoi = 0,
    Barycentric = 1,
    Mixed = 2
  };
  enum Neighbourhoods
  {
    OneRing = 0,
    Ball = 1,
    GeodesicDisc = 2
  };
  enum Orientations
  {
    Automatic = 0,
    AsWound = 1,
    Reversed = 2
  };
  enum ShapeIndexConventions
  {
    Thesis = 0,
    Koenderink = 1
  };

  ///@{
  /// AngleDefect (angle defect and cotangent formula), EdgeTensor or NormalFit.
  ISTHMUS_PARAMETER(Method, int);
  ///@}

  ///@{ Rule for the area assigned to a point: Voronoi, Barycentric or Mixed.
  ISTHMUS_PARAMETER(DualArea, int);
  ///@}

  ///@{ Neighbourhood over which the EdgeTensor is averaged: OneRing, Ball or
  /// GeodesicDisc.
  ISTHMUS_PARAMETER(Neighbourhood, int);
  ///@}

  ///@{
  /// Radius of Ball, GeodesicDisc and NormalFit, in the unit of the points (angstrom). 0: three
  /// times the mean edge length.
  ISTHMUS_PARAMETER(Radius, double);
  ///@}

  ///@{ Which side is outside: Automatic (closed components face outward and cavities in
  /// them inward, whichever way their triangles are wound; open components are as wound), AsWound
  /// (the side from which triangles are counter-clockwise) or Reversed (the other side).
  ISTHMUS_PARAMETER(Orientation, int);
  ///@}

  ///@{
  /// Sign of the shape index: Thesis (peak -1, pit +1) or Koenderink (peak +1, pit -1).
  ISTHMUS_PARAMETER(ShapeIndexConvention, int);
  ///@}

  /// The arrays that the filter adds to its output, and which of them are optional.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// FlatTolerance, GaussianTolerance and MeanTolerance are the bounds below which `SurfaceType`
  /// treats values as zero, without unit; a point is flat if curvedness x
  /// sqrt(PointArea) is at most FlatTolerance. NormalCurvatureDirection is that of
  /// `NormalCurvature`. (CurvatureArrays.h)
  ISTHMUS_CURVATURE_PROPERTIES();

  /// Which arrays to compute.
  ISTHMUS_OUTPUT_ARRAY_SELECTION();

protected:
  vtkSurfaceCurvature();
  ~vtkSurfaceCurvature() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  isthmus::SurfaceCurvatureOptions Parameters;

private:
  vtkSurfaceCurvature(const vtkSurfaceCurvature&) = delete;
  void operator=(const vtkSurfaceCurvature&) = delete;

  void AddArrays(const isthmus::SurfaceCurvatureResult& result, vtkPolyData* output);
};

#endif
