/**
 * @class   vtkSurfaceCurvature
 * @brief   curvature at the points of a surface mesh, by angle defect and cotangents or by edges
 *
 * The input, a vtkPolyData, is passed on with curvature arrays on its points. Polygons and strips
 * are split into triangles for the computation (the cells of the output stay as they are); vertices
 * and lines play no part.
 *
 * **Arrays**, on points, double, the same names and signs as vtkHessianCurvature's, each with a
 * switch: `GaussianCurvature` (1/length^2), `MeanCurvature`, `MaximumCurvature` (kappa_1),
 * `MinimumCurvature` (kappa_2), `Curvedness` (1/length), `ShapeIndex` (in [-1, 1]); off by default
 * `PrincipalDirection1`, `PrincipalDirection2` (unit vectors, of the EdgeTensor only),
 * `MeanCurvatureNormal` (H n, 1/length), `SurfaceType` (unsigned char, names in the field array
 * `SurfaceTypeNames`) and, of the EdgeTensor only, `NormalCurvature` in a given direction and, with
 * GenerateDifferentialForms, `GaussMap`, `ShapeOperator`, `FirstFundamentalForm`,
 * `SecondFundamentalForm`, `AreaElement` (CurvatureArrays.h; AngleDefect has `GaussMap` alone).
 * `PointArea` (length^2) is the area that belongs to a point by DualArea: the weight for means over
 * the surface; all together are the area of the surface. Field data `GaussianCurvatureIntegral` (no
 * unit) and `GaussBonnetEulerNumber`, that over 2 pi, close to the Euler number of a closed surface
 * (GaussBonnet.h).
 *
 * **Validity.** `CurvatureValid` is 1 where the values mean something. It is 0, and with it all
 * values but `PointArea`, at points on the boundary (over Ball and GeodesicDisc they are valid, but
 * one-sided, with an error of the order of edge length / Radius), at points without triangles,
 * around which the surface is not a disc or not wound alike, at triangles without area, and where
 * obtuse triangles make the Voronoi area negative (choose Mixed). A warning counts them; boundaries
 * are no reason for one. Points that coincide are one (SurfaceCleaning.h): a file with texture
 * coordinates or normals at corners has no border at its seams; `PointArea` is shared among them.
 *
 * **Sign.** A sphere has positive curvature, 1/r. Which side is outside is chosen by Orientation.
 *
 * **Method**: SurfaceCurvature.h has formulas and sources. AngleDefect is second order on meshes
 * that are regular in some parameters. On irregular ones it doesn't converge; take EdgeTensor with
 * a ball, or, for isosurfaces of a volume, vtkHessianCurvature.
 *
 * **Errors** (one message, empty output): coordinates that are not finite, damaged cells, negative
 * Radius or tolerance. An empty surface is not an error.
 *
 * **Cost.** O(triangles), for balls and discs times the triangles within Radius; in parallel,
 * bitwise the same on any number of threads. Memory about 300 bytes a point with all arrays. On
 * several MPI ranks, each works on its own piece, whose rim is then a boundary: gather the surface
 * first (in ParaView: Aggregate Dataset).
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

  ///@{
  /// Area that belongs to a point: Voronoi (default), Barycentric or Mixed.
  vtkSetClampMacro(DualArea, int, Voronoi, Mixed);
  vtkGetMacro(DualArea, int);
  ///@}

  ///@{
  /// Where the EdgeTensor is averaged: OneRing (default), Ball or GeodesicDisc.
  vtkSetClampMacro(Neighbourhood, int, OneRing, GeodesicDisc);
  vtkGetMacro(Neighbourhood, int);
  ///@}

  ///@{
  /// Radius of Ball and GeodesicDisc, in the unit of the points (angstrom). Default 0: three times
  /// the mean edge length.
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /// Which side is outside: Automatic (default: closed surfaces get the one that makes the enclosed
  /// volume positive, others are taken as wound), AsWound (from where triangles are
  /// counter-clockwise) or Reversed (the other).
  vtkSetClampMacro(Orientation, int, Automatic, Reversed);
  vtkGetMacro(Orientation, int);
  ///@}

  ///@{
  /// Sign of the shape index: Thesis (default; peak -1, pit +1) or Koenderink (peak +1, pit -1).
  vtkSetClampMacro(ShapeIndexConvention, int, Thesis, Koenderink);
  vtkGetMacro(ShapeIndexConvention, int);
  ///@}

  ///@{
  /// Whether to make the array of areas. Default on.
  vtkSetMacro(GeneratePointArea, bool);
  vtkGetMacro(GeneratePointArea, bool);
  vtkBooleanMacro(GeneratePointArea, bool);
  ///@}

  ///@{
  /// Whether to make `MeanCurvatureNormal`, the vector H n of length |H|: outward where the surface
  /// is convex, whatever Orientation says. Of the AngleDefect it is the cotangent formula itself,
  /// an estimate of the normal, too; of the EdgeTensor H times the mean normal of the triangles.
  /// Default off.
  vtkSetMacro(GenerateMeanCurvatureNormal, bool);
  vtkGetMacro(GenerateMeanCurvatureNormal, bool);
  vtkBooleanMacro(GenerateMeanCurvatureNormal, bool);
  ///@}

  /// GenerateGaussianCurvature and so on: which arrays to make; default on, but for principal
  /// directions, surface type, GenerateDifferentialForms and GenerateNormalCurvature (along
  /// NormalCurvatureDirection). FlatTolerance, GaussianTolerance and MeanTolerance: what
  /// `SurfaceType` takes for zero, no units, default 1e-3 each; a point is flat where curvedness x
  /// sqrt(PointArea) is at most FlatTolerance. CurvatureArrays.h has the whole list.
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
