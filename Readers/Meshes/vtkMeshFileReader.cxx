#include "vtkMeshFileReader.h"

#include "Core/NumberText.h"
#include "Files/ReaderGuard.h"
#include "Meshes/MeshConversion.h"

#include <vtkInformationVector.h>
#include <vtkUnstructuredGrid.h>

#include <string>

vtkMeshFileReader::vtkMeshFileReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMeshFileReader::~vtkMeshFileReader()
{
  this->SetFileName(nullptr);
}

int vtkMeshFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  auto* const grid = vtkUnstructuredGrid::GetData(output);
  return isthmus::ReadGuarded(
    this, this->FileName, grid, [this](unsigned long code) { this->SetErrorCode(code); },
    [&]
    {
      isthmus::CellMesh mesh;
      this->ReadMesh(mesh);
      const std::string inverted = isthmus::InvertedTetrahedra(mesh);
      if (!inverted.empty())
      {
        mesh.Warnings.push_back(inverted);
      }
      isthmus::ToGrid(mesh, grid);
      isthmus::AddNotes(mesh.Warnings, grid);
      if (!mesh.Warnings.empty())
      {
        std::string all;
        for (const std::string& warning : mesh.Warnings)
        {
          all += (all.empty() ? "" : " ") + warning;
        }
        vtkWarningMacro(<< isthmus::JoinText(this->FileName, ": ", all));
      }
    });
}

void vtkMeshFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
