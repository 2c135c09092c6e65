#include "vtkMEDITReader.h"

#include "Core/AlgorithmGuard.h"
#include "Files/ReaderGuard.h"
#include "Meshes/MEDITFile.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkMEDITReader);

const std::vector<isthmus::OutputArray>& vtkMEDITReader::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Reference", 1, "", ArrayChoice::None,
      "reference number in the file" },
    { 0, ArrayPlace::Cells, "Reference", 1, "", ArrayChoice::None, "reference number in the file" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "what was dropped, and signs of a damaged file; missing if there are none" },
  };
  return table;
}

int vtkMEDITReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeMEDIT);
}

void vtkMEDITReader::ReadMesh(isthmus::CellMesh& mesh)
{
  mesh = isthmus::ReadMEDIT(this->FileName, isthmus::MakeProgress(this));
}
