/**
 * @file SurfacePatch.h
 * @brief The edge tensor over the part of a triangle surface within a distance of a point.
 */
#ifndef isthmus_SurfacePatch_h
#define isthmus_SurfacePatch_h

#include "Curvature/EdgeBends.h"
#include "vtkIsthmusFiltersCurvatureModule.h"

#include <queue>
#include <vector>

namespace isthmus
{

/// Sums over balls and geodesic discs about points of one surface. It keeps scratch memory (4 bytes
/// a triangle, 16 a point for discs), so make one for many points, and one for each thread.
class VTKISTHMUSFILTERSCURVATURE_EXPORT SurfacePatch
{
public:
  SurfacePatch(
    const SurfaceView& mesh, const TriangleStars& stars, const EdgeBends& bends, double radius);

  /// Part within the ball that hangs together with `point`; edges and triangles are cut exactly.
  TensorSums OverBall(vtkIdType point);

  /// Part within the geodesic disc; distances by unfolding triangle after triangle from the nearest
  /// points outwards, linear within triangles.
  TensorSums OverDisc(vtkIdType point);

private:
  void SpreadDistances(vtkIdType point);
  void Reach(vtkIdType point, double distance);
  double Distance(vtkIdType point) const;
  double AcrossTriangle(vtkIdType known1, vtkIdType known2, vtkIdType target) const;
  void AddDiscTriangle(MeshTriangle triangle, TensorSums& sums) const;
  bool Visit(MeshTriangle triangle);

  SurfaceView Mesh;
  const TriangleStars& Stars;
  const EdgeBends& Bends;
  double Radius;

  // A triangle was visited, a point reached, for this centre if its stamp is the current one.
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
