/**
 * @file WindingNumber.h
 * @brief Winding number of a triangle soup, which may be open or cross itself, around a point.
 *
 * Generalised winding number: A. Jacobson, L. Kavan, O. Sorkine-Hornung, ACM Trans. Graph. 32
 * (2013) 33, doi:10.1145/2461912.2461916: the solid angles of all triangles over 4 pi, which is 1
 * inside a closed surface, 0 outside, and in between near holes. By a tree, as G. Barill et al.,
 * ACM Trans. Graph. 37 (2018) 43, doi:10.1145/3197517.3201337: distant parts are each replaced by
 * one dipole.
 */
#ifndef isthmus_WindingNumber_h
#define isthmus_WindingNumber_h

#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersSurfacesModule.h"

namespace isthmus
{

/// Solid angle of the triangle as seen from the origin: A. van Oosterom, J. Strackee, IEEE Trans.
/// Biomed. Eng. 30 (1983) 125, doi:10.1109/TBME.1983.325207.
VTKISTHMUSFILTERSSURFACES_EXPORT double SolidAngle(
  const Point3& a, const Point3& b, const Point3& c);

/// Building takes O(n log n) and 130 bytes for each triangle; a query evaluates O(log n) triangles.
/// Queries may run in parallel. Parts farther away than three times their radius are replaced by
/// dipoles, with an error of about 0.01, which is sufficient to distinguish 0 from 1.
class VTKISTHMUSFILTERSSURFACES_EXPORT WindingNumber
{
public:
  /// @pre corners exist and are finite.
  explicit WindingNumber(const SurfaceView& mesh);

  double operator()(const Point3& x) const;

private:
  struct Part
  {
    Point3 Center;      ///< mean of the triangles' middles, by area
    Point3 AreaNormal;  ///< sum of theirs
    double Radius;      ///< of a ball about Center that holds the triangles
    std::int64_t First; ///< triangle of a leaf, else the left child
    std::int64_t Count; ///< triangles of a leaf, else 0
  };

  void Build(std::size_t part, std::int64_t first, std::int64_t last,
    std::vector<std::int64_t>& order, const SurfaceView& mesh);
  void Summarise(Part& part, std::int64_t first, std::int64_t last,
    const std::vector<std::int64_t>& order, const SurfaceView& mesh) const;

  std::vector<Part> Parts;
  std::vector<std::array<Point3, 3>> Corners; ///< leaf by leaf
};

}

#endif
