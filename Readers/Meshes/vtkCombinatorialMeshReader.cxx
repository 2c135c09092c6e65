#include "vtkCombinatorialMeshReader.h"

#include "CellComplex/GridCells.h"
#include "Files/OpenByteSource.h"
#include "Files/ReaderGuard.h"
#include "Meshes/CombinatorialMeshFile.h"
#include "Meshes/MeshConversion.h"

#include <vtkCellType.h>
#include <vtkErrorCode.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkCombinatorialMeshReader);

const std::vector<isthmus::OutputArray>& vtkCombinatorialMeshReader::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "NAME", 0, "", ArrayChoice::None,
      "attributes of the vertices, by their names" },
    { 0, ArrayPlace::Cells, "NAME", 0, "", ArrayChoice::None,
      "attributes of the cells, by their names" },
  };
  return table;
}

namespace
{

/// How cells of one type of the file are passed to VTK.
struct Translation
{
  int VTKType = VTK_POLYHEDRON;
  std::vector<int> Order; // of the file's vertices in VTK's cell; unused for polyhedra
};

/// The faces with their beginnings and order made comparable.
isthmus::FaceList NormalizeFaces(isthmus::FaceList faces)
{
  for (std::vector<int>& face : faces)
  {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

Translation FindTranslation(const isthmus::CellType& type)
{
  if (type.Name().rfind("polyhedron", 0) == 0)
  {
    return {};
  }
  const isthmus::FaceList faces = NormalizeFaces(type.Faces());
  for (const isthmus::GridCellType& known : isthmus::LinearCellTypes())
  {
    if (faces == NormalizeFaces(known.Type.Faces()))
    {
      Translation translation{ known.VTKType, known.TurnedOut };
      for (std::size_t i = 0; i < translation.Order.size(); ++i)
      {
        translation.Order[i] = static_cast<int>(i);
      }
      return translation;
    }
  }
  if (faces == NormalizeFaces(isthmus::CellType::Prism().Faces()))
  {
    return { VTK_WEDGE, { 0, 2, 1, 3, 5, 4 } };
  }
  return {};
}

void InsertPolyhedron(
  const isthmus::CellType& type, const std::int64_t* vertices, vtkUnstructuredGrid* grid)
{
  std::vector<vtkIdType> points(vertices, vertices + type.NumberOfVertices());
  std::vector<vtkIdType> stream;
  for (const std::vector<int>& face : type.Faces())
  {
    stream.push_back(static_cast<vtkIdType>(face.size()));
    for (const int vertex : face)
    {
      stream.push_back(vertices[vertex]);
    }
  }
  grid->InsertNextCell(VTK_POLYHEDRON, static_cast<vtkIdType>(points.size()), points.data(),
    static_cast<vtkIdType>(type.Faces().size()), stream.data());
}

void InsertCells(const isthmus::CombinatorialMesh& mesh, vtkUnstructuredGrid* grid)
{
  grid->AllocateEstimate(mesh.NumberOfCells(), 4);
  const std::int64_t* vertices = mesh.CellVertices.data();
  for (const isthmus::CellRun& run : mesh.Runs)
  {
    const isthmus::CellType& type = mesh.Types[run.Type];
    const Translation translation = FindTranslation(type);
    std::vector<vtkIdType> points(translation.Order.size());
    for (std::int64_t c = 0; c < run.NumberOfCells; ++c, vertices += type.NumberOfVertices())
    {
      if (translation.VTKType == VTK_POLYHEDRON)
      {
        InsertPolyhedron(type, vertices, grid);
        continue;
      }
      std::transform(translation.Order.begin(), translation.Order.end(), points.begin(),
        [&](int vertex) { return vertices[vertex]; });
      grid->InsertNextCell(
        translation.VTKType, static_cast<vtkIdType>(points.size()), points.data());
    }
  }
}

void Fill(const isthmus::CombinatorialMesh& mesh, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkPoints> points;
  points->SetData(isthmus::ToDataArray(mesh.Coordinates, 3));
  grid->SetPoints(points);
  InsertCells(mesh, grid);
  isthmus::AddAttributes(mesh.Attributes, grid);
}

std::string Contents(const std::string& path, const isthmus::ProgressCallback& progress)
{
  try
  {
    std::error_code none;
    // An empty file is reported by its missing first line.
    if (std::filesystem::is_regular_file(path, none) && std::filesystem::is_empty(path, none))
    {
      return {};
    }
    const auto source = isthmus::OpenTextSource(path);
    std::string contents = isthmus::ReadAll(*source, progress);
    const std::string_view firstLine(contents.data(), contents.find('\n'));
    if (source->ChangesLineEnds() && firstLine.find("binary") != std::string_view::npos)
    {
      throw isthmus::ReaderError(isthmus::ReaderFailure::Damaged,
        path +
          ": the line ends of the file were changed to carriage returns, and its binary numbers "
          "with them. Fetch or write it again.");
    }
    return contents;
  }
  catch (const isthmus::ReaderError& error)
  {
    if (error.Kind != isthmus::ReaderFailure::NoSuchFile)
    {
      throw;
    }
    throw isthmus::ReaderError(
      error.Kind, "The file '" + path + "' can't be opened: check its name and permissions.");
  }
}

isthmus::CombinatorialMesh ParseMesh(const std::string& contents, const std::string& path)
{
  try
  {
    return isthmus::ParseCombinatorialMesh(contents);
  }
  catch (const std::runtime_error& error)
  {
    throw isthmus::ReaderError(
      isthmus::ReaderFailure::Damaged, path + ": " + std::string(error.what()));
  }
}

}

vtkCombinatorialMeshReader::vtkCombinatorialMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkCombinatorialMeshReader::~vtkCombinatorialMeshReader()
{
  this->SetFileName(nullptr);
}

int vtkCombinatorialMeshReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName,
    [](const char* path)
    {
      const std::string magic = "isthmus-combinatorial-mesh";
      std::string begin(magic.size(), '\0');
      try
      {
        const auto source = isthmus::OpenTextSource(path);
        return source->Read(0, begin.data(), begin.size()) == begin.size() && begin == magic;
      }
      catch (const std::exception&)
      {
        return false;
      }
    });
}

int vtkCombinatorialMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const isthmus::ProgressCallback progress = isthmus::MakeProgress(this);
  return isthmus::ReadGuarded(
    this, this->FileName, output, [this](unsigned long code) { this->SetErrorCode(code); },
    [&]()
    {
      const std::string contents = Contents(this->FileName, isthmus::Between(progress, 0.0, 0.2));
      isthmus::Report(progress, 0.2);
      const isthmus::CombinatorialMesh mesh = ParseMesh(contents, this->FileName);
      isthmus::Report(progress, 0.7);
      Fill(mesh, output);
      isthmus::Report(progress, 1.0);
    });
}

void vtkCombinatorialMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
