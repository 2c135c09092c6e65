/**
 * @class   vtkSurfaceCurvature
 * @brief   Computes curvature at the points of a surface mesh, by angle defect and cotangents or by
 * edges.
 *
 * The input, a vtkPolyData, is passed on with curvature arrays on its points. Polygons and strips
 * are split into triangles for the computation (the cells of the output are unchanged); vertices
 * and lines are ignored.
 *
 * **Arrays**, on points, double, with the same names and signs as in vtkHessianCurvature, each with
 * a switch: `GaussianCurvature` (1/length^2), `MeanCurvature`, `MaximumCurvature` (kappa_1),
 * `MinimumCurvature` (kappa_2), `Curvedness` (1/length), `ShapeIndex` (in [-1, 1]); off by default
 * `PrincipalDirection1`, `PrincipalDirection2` (unit vectors, with EdgeTensor only),
 * `MeanCurvatureNormal` (H n, 1/length), `SurfaceType` (unsigned char, names in the field array
 * `SurfaceTypeNames`) and, with EdgeTensor only, `NormalCurvature` in a given direction and, with
 * GenerateDifferentialForms, `GaussMap`, `ShapeOperator`, `FirstFundamentalForm`,
 * `SecondFundamentalForm`, `AreaElement` (CurvatureArrays.h; AngleDefect provides only `GaussMap`).
 * `PointArea` (length^2) is the area assigned to a point by DualArea, the weight for means over the
 * surface; the sum over all points is the area of the surface. Field data
 * `GaussianCurvatureIntegral` (no unit) and `GaussBonnetEulerNumber`, the integral divided by 2 pi,
 * which is close to the Euler number of a closed surface (GaussBonnet.h).
 *
 * **Validity.** `CurvatureValid` is 1 where the values are meaningful. It is 0, and all values
 * except `PointArea` are 0, at points on the boundary (with Ball and GeodesicDisc these are valid,
 * but one-sided, with an error of the order of edge length / Radius), at points without triangles,
 * at points around which the surface is not a disc or not consistently oriented, at triangles
 * without area, and where obtuse triangles make the Voronoi area negative (choose Mixed). A warning
 * counts such points, except those on the boundary. Coinciding points are treated as one
 * (SurfaceCleaning.h), so a file with texture coordinates or normals at corners has no boundary at
 * its seams; `PointArea` is divided among them.
 *
 * **Sign.** A sphere has positive curvature, 1/r. Which side is outside is chosen by Orientation.
 *
 * **Method**: formulas and sources are in SurfaceCurvature.h. AngleDefect is of second order on
 * meshes that are regular in some parametrisation. On irregular meshes it does not converge: use
 * EdgeTensor with a ball or, for isosurfaces of a volume, vtkHessianCurvature.
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
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

namespace isthmus
{
struct SurfaceCurvatureResult;
}

class VTKISTHMUSFILTERSCURVATURE_EXPORT vtkSurfaceCurvature : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceCurvature* New();
  vtkTypeMacro(vtkSurfaceCurvature, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    AngleDefect = 0,
    EdgeTensor = 1
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
  /// AngleDefect (default: angle defect and cotangent formula) or EdgeTensor.
  vtkSetClampMacro(Method, int, AngleDefect, EdgeTensor);
  vtkGetMacro(Method, int);
  ///@}

  ///@{ Rule for the area assigned to a point: Voronoi (default), Barycentric or Mixed.
  vtkSetClampMacro(DualArea, int, Voronoi, Mixed);
  vtkGetMacro(DualArea, int);
  ///@}

  ///@{ Neighbourhood over which the EdgeTensor is averaged: OneRing (default), Ball or
  /// GeodesicDisc.
  vtkSetClampMacro(Neighbourhood, int, OneRing, GeodesicDisc);
  vtkGetMacro(Neighbourhood, int);
  ///@}

  ///@{
  /// Radius of Ball and GeodesicDisc, in the unit of the points (angstrom). Default 0: three times
  /// the mean edge length.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{ Which side is outside: Automatic (default: closed components face outward and cavities in
  /// them inward, whichever way their triangles are wound; open components are as wound), AsWound
  /// (the side from which triangles are counter-clockwise) or Reversed (the other side).
  vtkSetClampMacro(Orientation, int, Automatic, Reversed);
  vtkGetMacro(Orientation, int);
  ///@}

  ///@{
  /// Sign of the shape index: Thesis (default; peak -1, pit +1) or Koenderink (peak +1, pit -1).
  vtkSetClampMacro(ShapeIndexConvention, int, Thesis, Koenderink);
  vtkGetMacro(ShapeIndexConvention, int);
  ///@}

  ///@{ Whether to compute the array `PointArea`. Default on.
  vtkSetMacro(GeneratePointArea, bool);
  vtkGetMacro(GeneratePointArea, bool);
  vtkBooleanMacro(GeneratePointArea, bool);
  ///@}

  ///@{ Whether to compute `MeanCurvatureNormal`, the vector H n of length |H|, which points outward
  /// where the surface is convex, whatever Orientation is. With AngleDefect it comes from the
  /// cotangent formula itself, which also estimates the normal; with EdgeTensor it is H times the
  /// mean normal of the triangles. Default off.
  vtkSetMacro(GenerateMeanCurvatureNormal, bool);
  vtkGetMacro(GenerateMeanCurvatureNormal, bool);
  vtkBooleanMacro(GenerateMeanCurvatureNormal, bool);
  ///@}

  /// GenerateGaussianCurvature etc. select the arrays to compute. They are on by default, except
  /// for principal directions, surface type, GenerateDifferentialForms and GenerateNormalCurvature
  /// (along NormalCurvatureDirection). FlatTolerance, GaussianTolerance and MeanTolerance are the
  /// bounds below which `SurfaceType` treats values as zero, without unit, default 1e-3 each; a
  /// point is flat if curvedness x sqrt(PointArea) is at most FlatTolerance. The whole list is in
  /// CurvatureArrays.h.
  ISTHMUS_CURVATURE_ARRAYS();

protected:
  vtkSurfaceCurvature() = default;
  ~vtkSurfaceCurvature() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Method = AngleDefect;
  int DualArea = Voronoi;
  int Neighbourhood = OneRing;
  double Radius = 0.0;
  int Orientation = Automatic;
  int ShapeIndexConvention = Thesis;
  bool GeneratePointArea = true;
  bool GenerateMeanCurvatureNormal = false;

private:
  vtkSurfaceCurvature(const vtkSurfaceCurvature&) = delete;
  void operator=(const vtkSurfaceCurvature&) = delete;

  void AddArrays(const isthmus::SurfaceCurvatureResult& result, vtkPolyData* output);
};

#endif
