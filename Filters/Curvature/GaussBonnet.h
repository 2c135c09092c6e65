/**
 * @file GaussBonnet.h
 * @brief The integral of the Gaussian curvature over a surface, as a check of its curvature.
 *
 * By the theorem of Gauss and Bonnet (M. P. do Carmo, Differential Geometry of Curves and Surfaces,
 * 1976, section 4-5) a closed surface has
 *
 *     integral of K dA = 2 pi chi,   chi = 2 (components - genus) its Euler number,
 *
 * whatever its shape, so that the integral of a good K, divided by 2 pi, is close to an integer:
 * the Euler number that counting points, edges and triangles gives (Surface Measures). Where they
 * differ, K is wrong somewhere: the surface is too coarse, or not smooth enough, for its curvature.
 */
#ifndef isthmus_GaussBonnet_h
#define isthmus_GaussBonnet_h

class vtkFieldData;
class vtkPolyData;

namespace isthmus
{

/**
 * The integral of the point array GaussianCurvature over the polygons: the sum over triangles of
 * area times the mean at the corners. Where CurvatureValid is 0, and without these arrays, the
 * curvature counts as 0. O(triangles).
 * @throws as PolyDataTriangles.h does.
 */
double IntegralOfGaussian(vtkPolyData* surface);

/// Adds the field data `GaussianCurvatureIntegral` (no unit) and `GaussBonnetEulerNumber`, which is
/// that over 2 pi.
void AddGaussBonnet(double integral, vtkFieldData* fields);

}

#endif
