#include "vtkOFFSurfaceReader.h"

#include "Files/ReaderGuard.h"
#include "Meshes/MeshConversion.h"
#include "Meshes/OFFFile.h"

#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkOFFSurfaceReader);

const std::vector<isthmus::OutputArray>& vtkOFFSurfaceReader::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::None, "of NOFF files" },
    { 0, ArrayPlace::Points, "Colors", 4, "", ArrayChoice::None,
      "red, green, blue, opacity from 0 to 255; of COFF files" },
  };
  return table;
}

vtkOFFSurfaceReader::vtkOFFSurfaceReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkOFFSurfaceReader::~vtkOFFSurfaceReader()
{
  this->SetFileName(nullptr);
}

int vtkOFFSurfaceReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeOFF);
}

int vtkOFFSurfaceReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  auto* const surface = vtkPolyData::GetData(output);
  return isthmus::ReadGuarded(
    this, this->FileName, surface, [this](unsigned long code) { this->SetErrorCode(code); },
    [&] {
      isthmus::ToSurface(isthmus::ReadOFF(this->FileName, isthmus::MakeProgress(this)), surface);
    });
}

void vtkOFFSurfaceReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
