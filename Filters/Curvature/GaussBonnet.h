/**
 * @file GaussBonnet.h
 * @brief The integral of the Gaussian curvature over a surface, as a check of its curvature.
 *
 * By the Gauss-Bonnet theorem (M. P. do Carmo, Differential Geometry of Curves and Surfaces, 1976,
 * section 4-5), a closed surface has
 *
 *     integral of K dA = 2 pi chi,   chi = 2 (components - genus) its Euler number,
 *
 * whatever its shape. If K is accurate, its integral divided by 2 pi is therefore close to an
 * integer: the Euler number obtained by counting points, edges and triangles (Surface Measures). If
 * they differ, K is inaccurate somewhere, because the surface is too coarse or not smooth enough.
 */
#ifndef isthmus_GaussBonnet_h
#define isthmus_GaussBonnet_h

class vtkFieldData;
class vtkPolyData;

namespace isthmus
{

/**
 * The integral of the point array GaussianCurvature over the polygons: the sum over triangles of
 * area times the mean at the corners. Where CurvatureValid is 0, or if these arrays are missing,
 * the curvature counts as 0. O(triangles).
 * @throws the exceptions of PolyDataTriangles.h.
 */
double IntegrateGaussianCurvature(vtkPolyData* surface);

/// Adds the field data `GaussianCurvatureIntegral` (no unit) and `GaussBonnetEulerNumber`, which is
/// the integral divided by 2 pi.
void AddGaussBonnet(double integral, vtkFieldData* fields);

}

#endif
