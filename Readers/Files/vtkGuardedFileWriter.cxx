#include "vtkGuardedFileWriter.h"

#include "Core/PrintableText.h"
#include "Core/Progress.h"

#include <vtkErrorCode.h>
#include <vtkPointSet.h>

#include <stdexcept>

vtkGuardedFileWriter::~vtkGuardedFileWriter()
{
  this->SetFileName(nullptr);
}

int vtkGuardedFileWriter::Write()
{
  this->IsWritten = false;
  return this->Superclass::Write() != 0 && this->IsWritten ? 1 : 0;
}

void vtkGuardedFileWriter::WriteData()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  try
  {
    if (!this->FileName || !*this->FileName)
    {
      throw std::invalid_argument("There is no file name: set FileName.");
    }
    if (auto* const points = vtkPointSet::SafeDownCast(this->GetInput());
        points && points->GetNumberOfPoints() == 0)
    {
      throw std::invalid_argument("The input has no points, so there is nothing to write: it is "
                                  "empty where the filter before has failed.");
    }
    this->WriteFile();
    this->IsWritten = true;
  }
  catch (const isthmus::Cancelled&)
  {
  }
  catch (const std::exception& error)
  {
    this->SetErrorCode(vtkErrorCode::CannotOpenFileError);
    vtkErrorMacro(<< isthmus::Printable(error.what()));
  }
}

void vtkGuardedFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
