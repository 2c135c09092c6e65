/**
 * @file EdgeTensor.h
 * @brief The curvature tensor of a triangle surface from the dihedral angles at its edges.
 *
 * The tensor is summed over the part of the surface within a ball or a geodesic disc around a
 * point. See SurfaceCurvature.h for the formula and its sources.
 */
#ifndef isthmus_EdgeTensor_h
#define isthmus_EdgeTensor_h

#include "Core/TriangleMesh.h"
#include "Surfaces/TriangleStars.h"

#include <Eigen/Dense>

#include <array>
#include <queue>
#include <vector>

namespace isthmus
{

/// The contribution of a neighbourhood to the edge tensor.
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
/// from its corner e to the next. Built in parallel; 64 bytes per triangle.
class DihedralAngles
{
public:
  DihedralAngles(const SurfaceView& mesh, const TriangleStars& stars);

  /// Triangle on the other side; None at boundaries and where there is more than one.
  MeshTriangle Neighbour(MeshTriangle triangle, std::size_t edge) const
  {
    return this->Neighbours[triangle][edge];
  }

  double Area(MeshTriangle triangle) const { return this->Areas[triangle]; }

  /// Adds half of beta |part| e e^T for a part of the edge; the neighbour adds the other half.
  void AddEdge(MeshTriangle triangle, std::size_t edge, double part, TensorSums& sums) const;

private:
  SurfaceView Mesh;
  HandleVector<MeshTriangle, std::array<MeshTriangle, 3>> Neighbours;
  HandleVector<MeshTriangle, std::array<double, 3>> Angles; ///< beta, positive where convex
  HandleVector<MeshTriangle, double> Areas;
};

/// Principal curvatures from an edge tensor, already divided by the area, at a point with `normal`.
PrincipalFrame ComputePrincipalFrame(const Eigen::Matrix3d& tensor, const Eigen::Vector3d& normal);

/// Sums over balls and geodesic discs about points of one surface. It keeps scratch memory (4 bytes
/// per triangle, and 16 per point for discs), so use one object for many points, and one per
/// thread.
class EdgeTensorIntegrator
{
public:
  EdgeTensorIntegrator(const SurfaceView& mesh, const TriangleStars& stars,
    const DihedralAngles& dihedrals, double radius);

  /// The part of the surface within the ball that is connected with `point`; edges and triangles
  /// are cut exactly.
  TensorSums IntegrateOverBall(vtkIdType point);

  /// The part within the geodesic disc. Distances are computed by unfolding triangles from the
  /// nearest points outwards and are linear within triangles.
  TensorSums IntegrateOverDisc(vtkIdType point);

private:
  void SpreadDistances(vtkIdType point);
  void Reach(vtkIdType point, double distance);
  double Distance(vtkIdType point) const;
  double AcrossTriangle(vtkIdType known1, vtkIdType known2, vtkIdType target) const;
  void AddDiscTriangle(MeshTriangle triangle, TensorSums& sums) const;
  bool Visit(MeshTriangle triangle);

  SurfaceView Mesh;
  const TriangleStars& Stars;
  const DihedralAngles& Dihedrals;
  double Radius;

  // A triangle was visited, or a point reached, for this center if its stamp is the current one.
  unsigned int Stamp = 0;
  HandleVector<MeshTriangle, unsigned int> TriangleStamps;
  std::vector<unsigned int> PointStamps;
  std::vector<double> Distances;
  std::vector<MeshTriangle> Pending;
  using Front = std::pair<double, vtkIdType>;
  std::priority_queue<Front, std::vector<Front>, std::greater<Front>> Queue;
};

}

#endif
