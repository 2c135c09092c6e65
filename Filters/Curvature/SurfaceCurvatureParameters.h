/**
 * @file SurfaceCurvatureParameters.h
 * @brief What SurfaceCurvature is asked for, and what it answers; formulas are told there.
 */
#ifndef isthmus_SurfaceCurvatureParameters_h
#define isthmus_SurfaceCurvatureParameters_h

#include <vtkType.h>

#include <vector>

namespace isthmus
{

enum class CurvatureEstimate
{
  AngleDefect = 0, ///< angle defect and cotangent formula
  EdgeTensor = 1
};

/// Which area belongs to a point.
enum class DualArea
{
  Voronoi = 0,
  Barycentric = 1,
  Mixed = 2
};

/// Neighbourhood N of the edge tensor. Only what hangs together with the point counts.
enum class CurvatureNeighbourhood
{
  OneRing = 0,     ///< the triangles around the point; edges opposite to it count half
  Ball = 1,        ///< the part of the surface within Radius, edges and triangles cut exactly
  GeodesicDisc = 2 ///< the same, with the distance measured along the surface
};

/// Which side is outside.
enum class SurfaceOrientation
{
  Automatic = 0, ///< closed surfaces: the one that makes the volume positive; others: as wound
  AsWound = 1,   ///< the side from which triangles are counter-clockwise
  Reversed = 2   ///< the other
};

struct SurfaceCurvatureOptions
{
  CurvatureEstimate Estimate = CurvatureEstimate::AngleDefect;
  DualArea Area = DualArea::Voronoi;
  CurvatureNeighbourhood Neighbourhood = CurvatureNeighbourhood::OneRing;
  SurfaceOrientation Orientation = SurfaceOrientation::Automatic;
  double Radius = 0.0; ///< of ball and disc, length; 0: three times the mean edge length
};

/// One value (directions: three) for each point. Where Valid is 0, curvatures and directions are 0.
struct SurfaceCurvatureResult
{
  std::vector<double> Gaussian;
  std::vector<double> Mean;
  std::vector<double> HalfDifference; ///< (kappa_1 - kappa_2) / 2 = sqrt(H^2 - K), 0 where K > H^2
  std::vector<double> Area;           ///< area of the point; 0 where Irregular or Isolated
  std::vector<double> Direction1;     ///< unit vectors, of EdgeTensor only
  std::vector<double> Direction2;
  std::vector<unsigned char> Valid;

  vtkIdType BoundaryPoints = 0;   ///< invalid, but over Ball and GeodesicDisc: one-sided there
  vtkIdType IrregularPoints = 0;  ///< see StarKind; invalid
  vtkIdType DegeneratePoints = 0; ///< at a triangle without area; invalid
  vtkIdType AreaNotPositive = 0;  ///< obtuse triangles made the Voronoi area <= 0; invalid
};

}

#endif
