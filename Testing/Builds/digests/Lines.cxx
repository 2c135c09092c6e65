#include "Lines.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkMatrix3x3.h>
#include <vtkMolecule.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace isthmus::digests
{

namespace
{

/// 64-bit FNV-1a.
class Digest
{
public:
  void AddBytes(const void* data, std::size_t size)
  {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i)
    {
      this->State = (this->State ^ bytes[i]) * 1099511628211ULL;
    }
  }

  /// vtkIdType has 32 bits in some builds.
  void AddId(vtkIdType id)
  {
    const std::int64_t value = id;
    this->AddBytes(&value, sizeof value);
  }

  void AddText(const std::string& text)
  {
    this->AddId(static_cast<vtkIdType>(text.size()));
    this->AddBytes(text.data(), text.size());
  }

  std::string Text() const
  {
    char text[17];
    std::snprintf(text, sizeof text, "%016" PRIx64, this->State);
    return text;
  }

private:
  std::uint64_t State = 14695981039346656037ULL;
};

std::string Line(const std::string& name, const std::string& type, int components, vtkIdType tuples,
  const Digest& digest)
{
  return name + " " + type + " " + std::to_string(components) + " " + std::to_string(tuples) + " " +
    digest.Text();
}

/// The values as bytes: differences of the last bit count.
void AddValues(Digest& digest, vtkDataArray* array)
{
  vtkSmartPointer<vtkDataArray> plain = array;
  if (!array->HasStandardMemoryLayout())
  {
    plain.TakeReference(vtkDataArray::CreateDataArray(array->GetDataType()));
    plain->DeepCopy(array);
  }
  digest.AddBytes(plain->GetVoidPointer(0),
    static_cast<std::size_t>(plain->GetNumberOfValues()) *
      static_cast<std::size_t>(plain->GetDataTypeSize()));
}

std::string ArrayLine(const std::string& place, const std::string& name, vtkAbstractArray* array)
{
  Digest digest;
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    AddValues(digest, numbers);
  }
  else if (auto* texts = vtkStringArray::SafeDownCast(array))
  {
    for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i)
    {
      digest.AddText(texts->GetValue(i));
    }
  }
  else
  {
    throw std::runtime_error(place + "/" + name + ": no digest of " + array->GetClassName());
  }
  return Line(place + "/" + name, array->GetDataTypeAsString(), array->GetNumberOfComponents(),
    array->GetNumberOfTuples(), digest);
}

void AddArrays(Lines& lines, const std::string& place, vtkFieldData* data)
{
  auto* attributes = vtkDataSetAttributes::SafeDownCast(data);
  for (int i = 0; data && i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = data->GetAbstractArray(i);
    const std::string name =
      array->GetName() ? array->GetName() : "(unnamed " + std::to_string(i) + ")";
    std::string line = ArrayLine(place, name, array);
    const int role = attributes ? attributes->IsArrayAnAttribute(i) : -1;
    if (role >= 0)
    {
      line += std::string(" ") + vtkDataSetAttributes::GetAttributeTypeAsString(role);
    }
    lines.push_back(line);
  }
}

void AddPoints(Lines& lines, const std::string& output, vtkPoints* points)
{
  lines.push_back(points ? ArrayLine(output + "/points", "Points", points->GetData())
                         : Line(output + "/points/Points", "none", 3, 0, {}));
}

void AddCells(Lines& lines, const std::string& output, const std::string& name, vtkCellArray* cells)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  Digest digest;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, corners);
    digest.AddId(corners->GetNumberOfIds());
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      digest.AddId(corners->GetId(k));
    }
  }
  lines.push_back(
    Line(output + "/topology/" + name, "cells", 1, cells->GetNumberOfCells(), digest));
}

template <typename Number>
std::string NumbersLine(
  const std::string& name, const std::string& type, const Number* numbers, int count)
{
  Digest digest;
  digest.AddBytes(numbers, sizeof(Number) * static_cast<std::size_t>(count));
  return Line(name, type, count, 1, digest);
}

void AddGeometry(Lines& lines, const std::string& output, vtkImageData* image)
{
  lines.push_back(NumbersLine(output + "/topology/Extent", "int", image->GetExtent(), 6));
  lines.push_back(NumbersLine(output + "/points/Origin", "double", image->GetOrigin(), 3));
  lines.push_back(NumbersLine(output + "/points/Spacing", "double", image->GetSpacing(), 3));
  lines.push_back(
    NumbersLine(output + "/points/Direction", "double", image->GetDirectionMatrix()->GetData(), 9));
}

void AddGeometry(Lines& lines, const std::string& output, vtkPolyData* surface)
{
  AddPoints(lines, output, surface->GetPoints());
  AddCells(lines, output, "Verts", surface->GetVerts());
  AddCells(lines, output, "Lines", surface->GetLines());
  AddCells(lines, output, "Polys", surface->GetPolys());
  AddCells(lines, output, "Strips", surface->GetStrips());
}

void AddGeometry(Lines& lines, const std::string& output, vtkUnstructuredGrid* grid)
{
  AddPoints(lines, output, grid->GetPoints());
  AddCells(lines, output, "Cells", grid->GetCells());
  Digest types, faces;
  vtkIdType polyhedra = 0;
  vtkNew<vtkIdList> stream;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    types.AddId(grid->GetCellType(i));
    if (grid->GetCellType(i) == VTK_POLYHEDRON)
    {
      ++polyhedra;
      grid->GetFaceStream(i, stream);
      for (vtkIdType k = 0; k < stream->GetNumberOfIds(); ++k)
      {
        faces.AddId(stream->GetId(k));
      }
    }
  }
  lines.push_back(Line(output + "/topology/Types", "int", 1, grid->GetNumberOfCells(), types));
  if (polyhedra > 0)
  {
    lines.push_back(Line(output + "/topology/Faces", "cells", 1, polyhedra, faces));
  }
}

void AddMolecule(Lines& lines, const std::string& output, vtkMolecule* molecule)
{
  AddPoints(lines, output, molecule->GetPoints());
  Digest bonds;
  for (vtkIdType i = 0; i < molecule->GetNumberOfBonds(); ++i)
  {
    bonds.AddId(molecule->GetSourceVertex(i));
    bonds.AddId(molecule->GetTargetVertex(i));
  }
  lines.push_back(
    Line(output + "/topology/Bonds", "cells", 1, molecule->GetNumberOfBonds(), bonds));
  AddArrays(lines, output + "/vertex data", molecule->GetVertexData());
  AddArrays(lines, output + "/edge data", molecule->GetEdgeData());
}

void AddComposite(Lines& lines, const std::string& output, vtkCompositeDataSet* blocks)
{
  auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    AddLines(lines, output + "." + std::to_string(iterator->GetCurrentFlatIndex()),
      iterator->GetCurrentDataObject());
  }
}

}

void AddLines(Lines& lines, const std::string& output, vtkDataObject* object)
{
  if (!object)
  {
    throw std::runtime_error(output + ": no data object");
  }
  AddArrays(lines, output + "/field data", object->GetFieldData());
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(object))
  {
    AddComposite(lines, output, blocks);
  }
  else if (auto* table = vtkTable::SafeDownCast(object))
  {
    AddArrays(lines, output + "/rows", table->GetRowData());
  }
  else if (auto* molecule = vtkMolecule::SafeDownCast(object))
  {
    AddMolecule(lines, output, molecule);
  }
  else if (auto* set = vtkDataSet::SafeDownCast(object))
  {
    if (auto* image = vtkImageData::SafeDownCast(set))
    {
      AddGeometry(lines, output, image);
    }
    else if (auto* surface = vtkPolyData::SafeDownCast(set))
    {
      AddGeometry(lines, output, surface);
    }
    else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(set))
    {
      AddGeometry(lines, output, grid);
    }
    else
    {
      throw std::runtime_error(output + ": no digest of " + set->GetClassName());
    }
    AddArrays(lines, output + "/point data", set->GetPointData());
    AddArrays(lines, output + "/cell data", set->GetCellData());
  }
  else
  {
    throw std::runtime_error(output + ": no digest of " + object->GetClassName());
  }
}

void AddTimeSteps(Lines& lines, const std::string& output, vtkAlgorithm* algorithm, int port)
{
  vtkInformation* const information = algorithm->GetOutputInformation(port);
  auto* const key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (information->Has(key))
  {
    lines.push_back(NumbersLine(
      output + "/pipeline/TimeSteps", "double", information->Get(key), information->Length(key)));
  }
}

void AddFile(Lines& lines, const std::string& output, const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string content{ std::istreambuf_iterator<char>(stream), {} };
  Digest digest;
  digest.AddBytes(content.data(), content.size());
  lines.push_back(Line(output + "/" + file.filename().string(), "bytes", 1,
    static_cast<vtkIdType>(content.size()), digest));
}

bool IsEmpty(vtkDataObject* object)
{
  for (int kind = 0; kind < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++kind)
  {
    if (kind != vtkDataObject::FIELD && object->GetNumberOfElements(kind) > 0)
    {
      return false;
    }
  }
  return true;
}

}
