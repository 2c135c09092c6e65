/**
 * @file SurfaceCurvature.h
 * @brief Curvature at the points of a triangle surface, from the triangles around them.
 *
 * Three estimates. **Angle defect and cotangents**, over the triangles around a point v:
 *
 *     K = (2 pi - sum of angles at v) / A
 *     H n = 1 / (4 A) sum over edges (v, w) of (cot alpha + cot beta) (v - w)
 *
 * with alpha and beta the angles opposite to the edge, H positive if H n points along the outward
 * normal, and A the area assigned to v:
 *
 *  - Voronoi: A = 1/8 sum of (cot alpha + cot beta) |v - w|^2
 *  - barycentric: A = 1/3 of the triangles' areas
 *  - mixed: each triangle's Voronoi part; for an obtuse triangle, 1/2 (angle at v obtuse) or 1/4
 *    of its area
 *
 * With each rule, the areas of all points sum to the area of the surface. On meshes that are
 * regular in some parametrisation of a smooth surface, this and the edge tensor around a point
 * converge with second order. Where the area of a point is less than 1/32 of a neighbour's, both
 * get the mean over the points around it, weighted by area: the tiny pyramids of isosurfaces at
 * nodes that lie almost at the level have no curvature of their own. On irregular meshes the angle
 * defect does not converge (its error reaches a plateau).
 *
 * **Edge tensor**, over a neighbourhood N of v:
 *
 *     C = 1 / A' sum over edges of beta(e) |e in N| e e^T,   A' = area of N
 *
 * with beta the signed angle between the normals of an edge's triangles
 * (positive where convex) and e its unit vector. The eigenvector closest to the point's normal is
 * dropped; the other two eigenvalues are the principal curvatures, and the direction of each is the
 * eigenvector of the *other* one: a cylinder bends across its axis, but its bent edges lie along
 * the axis. The tensor becomes smaller as N turns away from the tangent plane of v.
 *
 * **Normal fit**, the most accurate on irregular and noisy meshes: with n_i the normals of the
 * points within Radius (means over triangles, weighted by area) and A_i a third of the triangles'
 * areas,
 *
 *     minimise over t and S the sum over i of A_i |turn(n_i) - t - S place(p_i)|^2
 *
 * where turn(n_i) is the vector of the tangent plane along which the normal of v turns to n_i, as
 * long as the angle, and place(p_i) has the direction of p_i - v in that plane and the length of
 * the arc that has this chord and turns by that angle. The eigenvectors of the symmetric part of S
 * are the principal directions, with their curvatures; a sphere with exact normals has no error
 * at any Radius.
 *
 * Sources: X. Feng's thesis, 2.27 to 2.31 (2.31 there without the exchange of directions);
 * S. Rusinkiewicz, "Estimating curvatures and their derivatives on triangle meshes", 2004,
 * doi:10.1109/TDPVT.2004.1335277, and J. Goldfeather and V. Interrante, 2004,
 * doi:10.1145/966131.966134 (fits of normals);
 * M. Meyer et al., "Discrete differential-geometry operators for triangulated 2-manifolds", 2003,
 * doi:10.1007/978-3-662-05105-4_2; D. Cohen-Steiner and J.-M. Morvan, "Restricted Delaunay
 * triangulations and normal cycle", 2003, doi:10.1145/777792.777839.
 *
 * Sign: a sphere of radius r with outward triangles has H = +1/r. Units: 1/length, K 1/length^2.
 */
#ifndef isthmus_SurfaceCurvature_h
#define isthmus_SurfaceCurvature_h

#include "Core/Progress.h"
#include "Core/TriangleMesh.h"
#include "Curvature/CurvatureDescriptors.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro

#include <vtkType.h>

#include <vector>

namespace isthmus
{

enum class CurvatureEstimate
{
  AngleDefect = 0, ///< angle defect and cotangent formula
  EdgeTensor = 1,
  NormalFit = 2 ///< over the part of the surface within Radius, whatever the Neighbourhood
};

/// The area assigned to a point.
enum class DualArea
{
  Voronoi = 0,
  Barycentric = 1,
  Mixed = 2
};

/// Neighbourhood N of the edge tensor. Only the part connected with the point counts.
enum class CurvatureNeighbourhood
{
  OneRing = 0,     ///< the triangles around the point; the edges opposite to it count half
  Ball = 1,        ///< the part of the surface within Radius, edges and triangles cut exactly
  GeodesicDisc = 2 ///< the same, with the distance measured along the surface
};

/// Which side is outside.
enum class SurfaceOrientation
{
  Automatic = 0, ///< closed parts outward, cavities in them inward (OrientOutward); others as wound
  AsWound = 1,   ///< the side from which triangles are counter-clockwise
  Reversed = 2   ///< the other
};

struct SurfaceCurvatureOptions : CurvatureDescriptorOptions
{
  CurvatureEstimate Method = CurvatureEstimate::AngleDefect;
  isthmus::DualArea DualArea = isthmus::DualArea::Voronoi;
  CurvatureNeighbourhood Neighbourhood = CurvatureNeighbourhood::OneRing;
  SurfaceOrientation Orientation = SurfaceOrientation::Automatic;
  double Radius = 0.0; ///< radius of ball, disc and normal fit; 0: three times the mean edge length
  bool Normals = false; ///< whether to compute Normal and MeanNormal
};

/// @throws std::invalid_argument with the name, the value and the range of an invalid parameter.
VTKISTHMUSFILTERSCURVATURE_EXPORT void Check(const SurfaceCurvatureOptions& options);

/// One value (directions: three) for each point. Where Valid is 0, curvatures and directions are 0.
struct SurfaceCurvatureResult
{
  std::vector<double> Gaussian;
  std::vector<double> Mean;
  std::vector<double> HalfDifference; ///< (kappa_1 - kappa_2) / 2 = sqrt(H^2 - K), 0 where K > H^2
  std::vector<double> Area;           ///< area of the point; 0 where Irregular or Isolated
  std::vector<double> Direction1;     ///< unit vectors, not for AngleDefect
  std::vector<double> Direction2;
  std::vector<double>
    Normal; ///< with Normals: outward unit vectors, area-weighted means over the triangles
  std::vector<double> MeanNormal; ///< H n; for AngleDefect the vector from the formula itself
  std::vector<unsigned char> Valid;

  vtkIdType BoundaryPoints =
    0; ///< invalid, except for Ball, GeodesicDisc and NormalFit, where they are one-sided
  vtkIdType IrregularPoints = 0; ///< see StarKind; invalid
  vtkIdType DegeneratePoints =
    0; ///< at a triangle without area (NormalFit: at such triangles only); invalid
  vtkIdType AreaNotPositive = 0; ///< obtuse triangles made the Voronoi area <= 0; invalid
};

/**
 * Computes the curvature at all points of `mesh`, in parallel.
 *
 * Points without triangles are invalid. Time: O(triangles) for AngleDefect and OneRing, times the
 * number of triangles within Radius for the others. Memory: about 100 bytes per point, plus 100 per
 * triangle for EdgeTensor or 32 per point for NormalFit.
 * @throws std::invalid_argument for a Radius that is negative or not finite, and Cancelled.
 */
VTKISTHMUSFILTERSCURVATURE_EXPORT SurfaceCurvatureResult ComputeSurfaceCurvature(
  const SurfaceView& mesh, const SurfaceCurvatureOptions& options,
  const ProgressCallback& progress = {});

}

#endif
