/**
 * @file EdgeBends.h
 * @brief How a triangle surface bends at its edges, and what that says about its curvature.
 */
#ifndef isthmus_EdgeBends_h
#define isthmus_EdgeBends_h

#include "Core/TriangleMesh.h"
#include "Surfaces/TriangleStars.h"
#include "vtkIsthmusFiltersCurvatureModule.h"

#include <Eigen/Dense>

#include <array>
#include <vector>

namespace isthmus
{

/// What a neighbourhood contributes to the edge tensor.
struct TensorSums
{
  Eigen::Matrix3d Tensor = Eigen::Matrix3d::Zero();
  double Area = 0.0;
};

/// Principal curvatures and directions.
struct PrincipalFrame
{
  double Maximum = 0.0;
  double Minimum = 0.0;
  Eigen::Vector3d Direction1 = Eigen::Vector3d::Zero();
  Eigen::Vector3d Direction2 = Eigen::Vector3d::Zero();
};

/// The neighbour and the bending angle across each edge of each triangle; edge e of a triangle runs
/// from its corner e to the next. Building is parallel; 64 bytes a triangle.
class VTKISTHMUSFILTERSCURVATURE_EXPORT EdgeBends
{
public:
  EdgeBends(const SurfaceView& mesh, const TriangleStars& stars);

  /// Triangle on the other side, None at boundaries and where there is not exactly one.
  MeshTriangle Neighbour(MeshTriangle triangle, std::size_t edge) const
  {
    return this->Neighbours[triangle][edge];
  }

  double Area(MeshTriangle triangle) const { return this->Areas[triangle]; }

  /// Adds half of beta |part| e e^T for a part of the edge; its other half comes with the
  /// neighbour.
  void AddEdge(MeshTriangle triangle, std::size_t edge, double part, TensorSums& sums) const;

private:
  SurfaceView Mesh;
  HandleVector<MeshTriangle, std::array<MeshTriangle, 3>> Neighbours;
  HandleVector<MeshTriangle, std::array<double, 3>> Angles; ///< beta, positive where convex
  HandleVector<MeshTriangle, double> Areas;
};

/// Principal curvatures from an edge tensor, already divided by the area, at a point with `normal`.
PrincipalFrame PrincipalFrameOf(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& normal);

}

#endif
