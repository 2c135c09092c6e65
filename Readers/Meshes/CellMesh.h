/**
 * @file CellMesh.h
 * @brief Contents of mesh files: points, cells of a few shapes, and arrays on both.
 */
#ifndef isthmus_CellMesh_h
#define isthmus_CellMesh_h

#include "Files/NumberTypes.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isthmus
{

/// One array on the vertices or on the cells of a mesh file.
struct MeshAttribute
{
  enum class Place
  {
    Vertices,
    Cells
  };
  Place On = Place::Vertices;
  std::string Name;
  std::int64_t Components = 1;
  NumberList Values; ///< components run fastest
};

/// Vertices are in VTK's order (vtkCell and its subclasses).
enum class CellShape : std::uint8_t
{
  Vertex,
  Line,
  Triangle,
  Quadrilateral,
  Polygon,
  Tetrahedron,
  Pyramid,
  Wedge,
  Hexahedron,
  QuadraticTetrahedron,
  QuadraticEdge,
  QuadraticTriangle,
  BiquadraticQuadrilateral,
  BiquadraticWedge,
  TriquadraticHexahedron
};

/// Number of vertices of each shape, in the order of CellShape; 0: any number.
inline constexpr std::array<std::int64_t, 15> VerticesOfShape{ 1, 2, 3, 4, 0, 4, 5, 6, 8, 10, 3, 6,
  9, 18, 27 };

/// Ids from 0. Attributes have a tuple for each point or each cell.
struct CellMesh
{
  std::vector<double> Coordinates;        ///< three for each point
  std::vector<CellShape> Shapes;          ///< one for each cell
  std::vector<std::int64_t> Offsets{ 0 }; ///< of each cell and the end, into Vertices
  std::vector<std::int64_t> Vertices;
  std::vector<MeshAttribute> Attributes;
  std::vector<std::string> Warnings; ///< dropped parts of the file, one message each

  std::int64_t NumberOfPoints() const
  {
    return static_cast<std::int64_t>(this->Coordinates.size() / 3);
  }
  std::int64_t NumberOfCells() const { return static_cast<std::int64_t>(this->Shapes.size()); }

  /// Completes a cell whose vertices were appended to Vertices.
  void EndCell(CellShape shape)
  {
    this->Shapes.push_back(shape);
    this->Offsets.push_back(static_cast<std::int64_t>(this->Vertices.size()));
  }

  /// The attribute with this location and name, or null.
  const MeshAttribute* Find(MeshAttribute::Place on, std::string_view name) const
  {
    for (const MeshAttribute& attribute : this->Attributes)
    {
      if (attribute.On == on && attribute.Name == name)
      {
        return &attribute;
      }
    }
    return nullptr;
  }
};

}

#endif
