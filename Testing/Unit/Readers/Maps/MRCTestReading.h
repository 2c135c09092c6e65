/**
 * @file MRCTestReading.h
 * @brief Reads a file with vtkMRCMapReader and keeps its messages.
 */
#ifndef isthmus_MRCTestReading_h
#define isthmus_MRCTestReading_h

#include "vtkMRCMapReader.h"

#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>

#include <string>

namespace isthmus::testing
{

/// A reader whose errors and warnings are collected instead of printed.
class MRCTestReading
{
public:
  explicit MRCTestReading(const char* path = nullptr)
  {
    this->Reader->SetFileName(path);
    this->Reader->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Reader->AddObserver(vtkCommand::WarningEvent, this->Observer);
    // The pipeline adds a message of its own when a request fails.
    this->Reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->PipelineObserver);
  }

  vtkMRCMapReader* operator->() { return this->Reader; }

  vtkImageData* Update()
  {
    this->Observer->Clear();
    this->Reader->Update();
    return this->Reader->GetOutput();
  }

  bool HasFailed() const { return this->Observer->GetError(); }
  std::string Error() const { return this->Observer->GetErrorMessage(); }
  std::string Warning() const { return this->Observer->GetWarningMessage(); }

  /// Value of a node by its indices along x, y, z.
  double At(int i, int j, int k, int component = 0)
  {
    return this->Reader->GetOutput()->GetScalarComponentAsDouble(i, j, k, component);
  }

  vtkFieldData* Fields() { return this->Reader->GetOutput()->GetFieldData(); }
  double Number(const char* field, int component = 0)
  {
    vtkDataArray* const array = this->Fields()->GetArray(field);
    return array ? array->GetComponent(0, component) : -1e300;
  }
  std::string Text(const char* field, int index = 0)
  {
    auto* const array = vtkStringArray::SafeDownCast(this->Fields()->GetAbstractArray(field));
    return array && index < array->GetNumberOfValues() ? array->GetValue(index) : "(none)";
  }
  vtkIdType Count(const char* field)
  {
    vtkAbstractArray* const array = this->Fields()->GetAbstractArray(field);
    return array ? array->GetNumberOfTuples() : -1;
  }

private:
  vtkNew<vtkMRCMapReader> Reader;
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkTest::ErrorObserver> PipelineObserver;
};

}

#endif
