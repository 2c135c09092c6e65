/**
 * @file VolumeMeshFiles.h
 * @brief Reads the shared volume meshes for the tests: VTK, Medit, MFEM, Gmsh, Netgen, TetGen, OVM
 * and HEDRA files, as far as these files require.
 */
#ifndef isthmus_VolumeMeshFiles_h
#define isthmus_VolumeMeshFiles_h

#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace isthmus::testing
{

using Ids = std::vector<vtkIdType>;

/// Fills a grid from a file's words.
class VolumeMeshFile
{
public:
  explicit VolumeMeshFile(const std::filesystem::path& path)
    : Folder(path.parent_path())
    , Stem(path.stem().string())
    , Words(Contents(path))
  {
    this->Grid->SetPoints(vtkNew<vtkPoints>());
    this->Grid->GetPoints()->SetDataTypeToDouble();
    this->Grid->AllocateEstimate(1000, 8);
    const std::string ending = path.extension().string();
    if (ending == ".mesh")
    {
      this->Words.str().rfind("MFEM", 0) == 0 ? this->ReadMFEM() : this->ReadMedit();
    }
    else if (ending == ".msh")
    {
      this->ReadGmsh();
    }
    else if (ending == ".vol")
    {
      this->ReadNetgen();
    }
    else if (ending == ".ele")
    {
      this->ReadTetGen();
    }
    else if (ending == ".ovm")
    {
      this->ReadOVM();
    }
    else if (ending == ".hedra")
    {
      this->ReadHEDRA();
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Result() const { return this->Grid.Get(); }

private:
  static std::string Contents(const std::filesystem::path& path)
  {
    std::ifstream file(path, std::ios::binary);
    return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  }

  template <typename T = vtkIdType>
  T Next()
  {
    T value{};
    this->Words >> value;
    return value;
  }

  void SkipTo(const std::string& word)
  {
    this->Words.clear();
    this->Words.seekg(0);
    for (std::string found; found != word;)
    {
      if (!(this->Words >> found))
      {
        throw std::runtime_error("no " + word);
      }
    }
  }

  void Points(vtkIdType count, bool reference = false)
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double x = this->Next<double>(), y = this->Next<double>(), z = this->Next<double>();
      this->Grid->GetPoints()->InsertNextPoint(x, y, z);
      if (reference)
      {
        this->Next<double>();
      }
    }
  }

  /// A cell whose vertices are the next words, numbered from `base`.
  void Cell(int type, vtkIdType size, vtkIdType base)
  {
    Ids ids;
    for (vtkIdType i = 0; i < size; ++i)
    {
      ids.push_back(this->Next() - base);
    }
    this->Grid->InsertNextCell(type, size, ids.data());
  }

  void ReadMedit()
  {
    const std::map<std::string, int> cells{ { "Tetrahedra", VTK_TETRA },
      { "Hexahedra", VTK_HEXAHEDRON } };
    const std::map<std::string, int> skipped{ { "Triangles", 4 }, { "Quadrilaterals", 5 },
      { "Edges", 3 } };
    this->SkipTo("Dimension");
    for (std::string word; this->Words >> word;)
    {
      if (word == "Vertices")
      {
        this->Points(this->Next(), true);
      }
      else if (cells.count(word))
      {
        for (vtkIdType left = this->Next(); left > 0; --left)
        {
          this->Cell(cells.at(word), cells.at(word) == VTK_TETRA ? 4 : 8, 1);
          this->Next();
        }
      }
      else if (skipped.count(word))
      {
        for (vtkIdType left = skipped.at(word) * this->Next(); left > 0; --left)
        {
          this->Next();
        }
      }
    }
  }

  void ReadMFEM()
  {
    const std::map<vtkIdType, std::pair<int, vtkIdType>> types{ { 4, { VTK_TETRA, 4 } },
      { 5, { VTK_HEXAHEDRON, 8 } }, { 6, { VTK_WEDGE, 6 } }, { 7, { VTK_PYRAMID, 5 } } };
    this->SkipTo("vertices");
    const vtkIdType points = this->Next();
    this->Next();
    this->Points(points);
    this->SkipTo("elements");
    for (vtkIdType left = this->Next(); left > 0; --left)
    {
      this->Next();
      const auto type = types.at(this->Next());
      this->Cell(type.first, type.second, 0);
    }
  }

  /// Versions 2.2, text or binary, and 4.1 with one block of each; tetrahedra and skipped surfaces.
  void ReadGmsh()
  {
    this->SkipTo("$MeshFormat");
    const auto version = this->Next<double>();
    const bool binary = this->Next() == 1;
    this->SkipTo("$Nodes");
    if (version > 4)
    {
      this->SkipTo("$Nodes");
      this->Words.ignore(1);
      for (int i = 0; i < 7; ++i)
      {
        this->Next();
      }
      const vtkIdType count = this->Next();
      for (vtkIdType i = 0; i < count; ++i)
      {
        this->Next(); // numbers 1 ... count in order
      }
      this->Points(count);
      this->SkipTo("$Elements");
      for (int i = 0; i < 6; ++i)
      {
        this->Next();
      }
      this->Next(); // the type, 4: tetrahedra
      for (vtkIdType left = this->Next(); left > 0; --left)
      {
        this->Next();
        this->Cell(VTK_TETRA, 4, 1);
      }
      return;
    }
    binary ? this->ReadGmshBinary() : this->ReadGmshText();
  }

  void ReadGmshText()
  {
    for (vtkIdType left = this->Next(); left > 0; --left)
    {
      this->Next();
      this->Points(1);
    }
    this->SkipTo("$Elements");
    for (vtkIdType left = this->Next(); left > 0; --left)
    {
      this->Next();
      const vtkIdType type = this->Next();
      for (vtkIdType tags = this->Next(); tags > 0; --tags)
      {
        this->Next();
      }
      this->Cell(type == 4 ? VTK_TETRA : VTK_TRIANGLE, type == 4 ? 4 : 3, 1);
    }
  }

  template <typename T>
  T Raw()
  {
    T value{};
    this->Words.read(reinterpret_cast<char*>(&value), sizeof(T));
    return value;
  }

  void ReadGmshBinary()
  {
    vtkIdType left = this->Next();
    this->Words.ignore(1);
    for (; left > 0; --left)
    {
      this->Raw<int>();
      const auto x = this->Raw<double>(), y = this->Raw<double>(), z = this->Raw<double>();
      this->Grid->GetPoints()->InsertNextPoint(x, y, z);
    }
    this->SkipTo("$Elements");
    left = this->Next();
    this->Words.ignore(1);
    while (left > 0)
    {
      const int type = this->Raw<int>(), count = this->Raw<int>(), tags = this->Raw<int>();
      for (int i = 0; i < count; ++i, --left)
      {
        for (int tag = 0; tag < tags + 1; ++tag)
        {
          this->Raw<int>();
        }
        Ids ids;
        for (int v = 0; v < (type == 4 ? 4 : 3); ++v)
        {
          ids.push_back(this->Raw<int>() - 1);
        }
        this->Grid->InsertNextCell(
          type == 4 ? VTK_TETRA : VTK_TRIANGLE, static_cast<vtkIdType>(ids.size()), ids.data());
      }
    }
  }

  void ReadNetgen()
  {
    this->SkipTo("points");
    this->Points(this->Next());
    this->SkipTo("volumeelements");
    for (vtkIdType left = this->Next(); left > 0; --left)
    {
      this->Next();
      this->Next();
      this->Cell(VTK_TETRA, 4, 1);
    }
  }

  void ReadTetGen()
  {
    const std::string elements = this->Words.str();
    this->Words.str(Contents(this->Folder / (this->Stem + ".node")));
    vtkIdType count = this->Next();
    for (int i = 0; i < 3; ++i)
    {
      this->Next();
    }
    for (; count > 0; --count)
    {
      this->Next();
      this->Points(1);
    }
    this->Words.clear();
    this->Words.str(elements);
    count = this->Next();
    const vtkIdType size = this->Next();
    this->Next();
    for (; count > 0; --count)
    {
      this->Next();
      this->Cell(size == 10 ? VTK_QUADRATIC_TETRA : VTK_TETRA, size, 1);
    }
  }

  void Polyhedron(const std::vector<Ids>& faces)
  {
    Ids stream, points;
    for (const Ids& face : faces)
    {
      stream.push_back(static_cast<vtkIdType>(face.size()));
      stream.insert(stream.end(), face.begin(), face.end());
    }
    this->Grid->InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(faces.size()), stream.data());
  }

  void ReadOVM()
  {
    this->SkipTo("Vertices");
    this->Points(this->Next());
    this->SkipTo("Edges");
    Ids starts;
    for (vtkIdType left = 2 * this->Next(); left > 0; --left)
    {
      starts.push_back(this->Next()); // for half edges 2e and 2e + 1
    }
    this->SkipTo("Faces");
    std::vector<Ids> faces(static_cast<std::size_t>(this->Next()));
    for (Ids& face : faces)
    {
      for (vtkIdType left = this->Next(); left > 0; --left)
      {
        face.push_back(starts[static_cast<std::size_t>(this->Next())]);
      }
    }
    this->SkipTo("Polyhedra");
    for (vtkIdType left = this->Next(); left > 0; --left)
    {
      std::vector<Ids> own;
      for (vtkIdType size = this->Next(); size > 0; --size)
      {
        own.push_back(faces[static_cast<std::size_t>(this->Next() / 2)]);
      }
      this->Polyhedron(own);
    }
  }

  void ReadHEDRA()
  {
    const vtkIdType points = this->Next();
    std::vector<Ids> faces(static_cast<std::size_t>(this->Next()));
    const vtkIdType polyhedra = this->Next();
    this->Points(points);
    for (Ids& face : faces)
    {
      for (vtkIdType left = this->Next(); left > 0; --left)
      {
        face.push_back(this->Next() - 1);
      }
    }
    for (vtkIdType p = 0; p < polyhedra; ++p)
    {
      std::vector<Ids> own;
      for (vtkIdType size = this->Next(); size > 0; --size)
      {
        own.push_back(faces[static_cast<std::size_t>(std::abs(this->Next()) - 1)]);
      }
      this->Polyhedron(own);
    }
  }

  std::filesystem::path Folder;
  std::string Stem;
  std::stringstream Words;
  vtkNew<vtkUnstructuredGrid> Grid;
};

inline vtkSmartPointer<vtkUnstructuredGrid> ReadVolumeMesh(const std::filesystem::path& path)
{
  if (path.extension() == ".vtk")
  {
    vtkNew<vtkUnstructuredGridReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
  }
  return VolumeMeshFile(path).Result();
}

}

#endif
