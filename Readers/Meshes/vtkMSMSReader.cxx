#include "vtkMSMSReader.h"

#include "Core/ArrayMemory.h"
#include "Core/NamedColumns.h"
#include "Files/ReaderGuard.h"
#include "Meshes/MSMSReader.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkErrorCode.h>
#include <vtkFloatArray.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkMSMSReader);

const std::vector<isthmus::OutputArray>& vtkMSMSReader::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::None, "unit, away from the molecule" },
    { 0, ArrayPlace::Points, "AnalyticFace", 1, "", ArrayChoice::None,
      "number of the analytic face" },
    { 0, ArrayPlace::Points, "Atom", 1, "", ArrayChoice::None, "nearest atom, from 0" },
    { 0, ArrayPlace::Points, "SurfaceType", 1, "", ArrayChoice::None,
      "1 toric, 2 reentrant, 3 contact" },
    { 0, ArrayPlace::Cells, "SurfaceType", 1, "", ArrayChoice::None,
      "1 toric, 2 reentrant, 3 contact" },
    { 0, ArrayPlace::Cells, "AnalyticFace", 1, "", ArrayChoice::None,
      "number of the analytic face" },
    { 0, ArrayPlace::Cells, "Component", 1, "", ArrayChoice::None,
      "index of the pair of files, from 0" },
  };
  return table;
}

namespace
{

void SetSurface(const isthmus::MSMSSurface& surface, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const auto normals = isthmus::NamedArray<vtkFloatArray>("Normals", 0, 3);
  for (std::size_t i = 0; i < surface.Points.size(); ++i)
  {
    points->InsertNextPoint(surface.Points[i].data());
    normals->InsertNextTuple(surface.Normals[i].data());
  }
  vtkNew<vtkCellArray> triangles;
  const auto count = static_cast<vtkIdType>(surface.Triangles.size());
  isthmus::ReserveCells(triangles, count, 3 * count);
  for (const auto& t : surface.Triangles)
  {
    triangles->InsertNextCell({ t[0], t[1], t[2] });
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->SetNormals(normals);
  isthmus::AddColumn<vtkIntArray>(
    output->GetPointData(), "AnalyticFace", surface.AnalyticFaceOfPoint);
  isthmus::AddColumn<vtkIntArray>(output->GetPointData(), "Atom", surface.SphereOfPoint);
  isthmus::AddColumn<vtkIntArray>(output->GetPointData(), "SurfaceType", surface.TypeOfPoint);
  isthmus::AddColumn<vtkIntArray>(output->GetCellData(), "SurfaceType", surface.TypeOfTriangle);
  isthmus::AddColumn<vtkIntArray>(
    output->GetCellData(), "AnalyticFace", surface.AnalyticFaceOfTriangle);
  isthmus::AddColumn<vtkIntArray>(output->GetCellData(), "Component", surface.ComponentOfTriangle);
}

}

vtkMSMSReader::vtkMSMSReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMSMSReader::~vtkMSMSReader()
{
  this->SetFileName(nullptr);
}

int vtkMSMSReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeMSMS);
}

int vtkMSMSReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  auto* surface = vtkPolyData::GetData(output);
  return isthmus::ReadGuarded(
    this, this->FileName, surface, [this](unsigned long code) { this->SetErrorCode(code); },
    [&]
    {
      const auto files = this->AllComponents ? isthmus::MSMSComponents(this->FileName)
                                             : std::vector<std::filesystem::path>{ this->FileName };
      isthmus::MSMSSurface read;
      const auto progress = isthmus::MakeProgress(this);
      for (std::size_t i = 0; i < files.size(); ++i)
      {
        const auto share = 1.0 / static_cast<double>(files.size());
        isthmus::ReadMSMS(files[i], static_cast<int>(i), read,
          isthmus::Between(
            progress, share * static_cast<double>(i), share * static_cast<double>(i + 1)));
      }
      SetSurface(read, surface);
    });
}

void vtkMSMSReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "AllComponents: " << this->AllComponents << "\n";
}
