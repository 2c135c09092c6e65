/**
 * @file TopologyFilterRun.h
 * @brief One run of a filter whose messages are collected.
 */
#ifndef isthmus_TopologyFilterRun_h
#define isthmus_TopologyFilterRun_h

#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>

#include <functional>
#include <string>

namespace isthmus::testing
{

template <typename Filter>
class TopologyFilterRun
{
public:
  explicit TopologyFilterRun(vtkDataObject* input, const std::function<void(Filter*)>& prepare = {})
  {
    this->Filtering->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Filtering->AddObserver(vtkCommand::WarningEvent, this->Observer);
    this->Filtering->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Pipeline);
    this->Filtering->SetInputData(input);
    if (prepare)
    {
      prepare(this->Filtering);
    }
    this->Filtering->Update();
  }

  vtkPolyData* Surface(int port)
  {
    return vtkPolyData::SafeDownCast(this->Filtering->GetOutputDataObject(port));
  }
  vtkUnstructuredGrid* Grid(int port)
  {
    return vtkUnstructuredGrid::SafeDownCast(this->Filtering->GetOutputDataObject(port));
  }
  std::string Messages() const
  {
    return this->Observer->GetErrorMessage() + this->Observer->GetWarningMessage();
  }

private:
  vtkNew<Filter> Filtering;
  vtkNew<vtkTest::ErrorObserver> Observer, Pipeline;
};

}

#endif
