// mesh_curvature: an algorithm without VTK's pipeline, a mesh in, a struct out. Prints the
// curvature of a torus at its outermost and innermost points, beside the exact values.

#include <Core/TriangleMesh.h>
#include <Curvature/SurfaceCurvature.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>

namespace
{

/// Radii of the torus around z, in angstrom: of the circle that the tube follows, and of the tube.
constexpr double Big = 20.0, Small = 5.0;
constexpr int Rows = 120, Columns = 40;

isthmus::TriangleMesh Torus()
{
  const double fullTurn = 2.0 * std::acos(-1.0);
  isthmus::TriangleMesh mesh;
  const auto id = [](int i, int j) -> vtkIdType { return i % Rows * Columns + j % Columns; };
  for (int i = 0; i < Rows; ++i)
  {
    for (int j = 0; j < Columns; ++j)
    {
      const double u = fullTurn * i / Rows, v = fullTurn * j / Columns;
      const double r = Big + Small * std::cos(v);
      mesh.Points.push_back({ r * std::cos(u), r * std::sin(u), Small * std::sin(v) });
      mesh.Triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      mesh.Triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  return mesh;
}

}

int main()
{
  try
  {
    const isthmus::SurfaceCurvatureResult curvature = isthmus::ComputeSurfaceCurvature(Torus(), {});
    const int outermost = 0, innermost = Columns / 2;
    std::cout << "Gaussian curvature outside " << curvature.Gaussian[outermost] << " (exact "
              << 1.0 / (Small * (Big + Small)) << "), inside " << curvature.Gaussian[innermost]
              << " (exact " << -1.0 / (Small * (Big - Small)) << ")\n";
    return EXIT_SUCCESS;
  }
  catch (const std::exception& error) // reports what is wrong with mesh or options
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
