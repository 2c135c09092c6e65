#include "Core/InnerAlgorithm.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNew.h>

#include <stdexcept>

namespace isthmus
{
namespace
{

vtkInformationStringKey* Failure()
{
  static auto* const key = vtkInformationStringKey::MakeKey("FAILURE", "isthmus");
  return key;
}

/// Listens to an algorithm and its executive for the lifetime of the object.
class InnerEvents
{
public:
  InnerEvents(vtkAlgorithm* inner, const ProgressCallback& progress,
    const std::function<void(const std::string&)>& warn)
    : Inner(inner)
    , Progress(progress)
    , Warn(warn)
  {
    this->Observer->SetClientData(this);
    this->Observer->SetCallback(InnerEvents::Follow);
    inner->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    inner->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    if (progress)
    {
      inner->AddObserver(vtkCommand::ProgressEvent, this->Observer);
    }
    if (warn)
    {
      inner->AddObserver(vtkCommand::WarningEvent, this->Observer);
    }
  }
  ~InnerEvents()
  {
    this->Inner->RemoveObserver(this->Observer);
    this->Inner->GetExecutive()->RemoveObserver(this->Observer);
  }
  InnerEvents(const InnerEvents&) = delete;
  InnerEvents& operator=(const InnerEvents&) = delete;

  void Throw() const
  {
    if (this->IsAborted)
    {
      throw Cancelled();
    }
    if (!this->Error.empty())
    {
      throw std::runtime_error(this->Error);
    }
  }

private:
  static void Follow(vtkObject*, unsigned long event, void* client, void* data)
  {
    auto* const self = static_cast<InnerEvents*>(client);
    if (event == vtkCommand::ProgressEvent)
    {
      if (!self->Progress(*static_cast<double*>(data)))
      {
        self->IsAborted = true;
        self->Inner->SetAbortExecute(1);
      }
      return;
    }
    const std::string message = PlainMessage(static_cast<const char*>(data));
    if (event == vtkCommand::WarningEvent)
    {
      self->Warn(message);
    }
    else if (self->Error.empty()) // errors of the executive only follow that of the algorithm
    {
      self->Error = message;
    }
  }

  vtkAlgorithm* Inner;
  const ProgressCallback& Progress;
  const std::function<void(const std::string&)>& Warn;
  vtkNew<vtkCallbackCommand> Observer;
  std::string Error;
  bool IsAborted = false;
};

}

std::string GetFailure(vtkAlgorithm* self)
{
  const char* const message = Failure()->Get(self->GetInformation());
  return message ? message : "";
}

void SetFailure(vtkAlgorithm* self, const std::string& message)
{
  if (message.empty())
  {
    self->GetInformation()->Remove(Failure());
  }
  else
  {
    Failure()->Set(self->GetInformation(), message);
  }
}

std::string PlainMessage(const std::string& message)
{
  // "ERROR: In FILE, line N\nCLASS (ADDRESS): MESSAGE\n\n"
  const std::size_t start = message.find("): ");
  std::string text = message.substr(start == std::string::npos ? 0 : start + 3);
  text.erase(text.find_last_not_of('\n') + 1);
  return text;
}

void UpdateInner(vtkAlgorithm* inner, const ProgressCallback& progress,
  const std::function<void(const std::string&)>& warn)
{
  const InnerEvents events(inner, progress, warn);
  inner->SetAbortExecute(0);
  inner->Update();
  events.Throw();
  // There are no events if VTK's messages are switched off, or if the same one was reported before.
  const std::string failure = GetFailure(inner);
  if (!failure.empty())
  {
    throw std::runtime_error(failure);
  }
}

}
