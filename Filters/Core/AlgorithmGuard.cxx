#include "Core/AlgorithmGuard.h"

#include "Core/PrintableText.h"

#include <vtkAlgorithm.h>
#include <vtkDemandDrivenPipeline.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>

#include <algorithm>

namespace isthmus
{
namespace
{

/// The last message and its time, stored with the algorithm, so that it is deleted with it.
vtkInformationStringKey* LastReport()
{
  static auto* const key = vtkInformationStringKey::MakeKey("LAST_WORDS", "isthmus");
  return key;
}

vtkMTimeType LastChange(vtkAlgorithm* self)
{
  auto* executive = vtkDemandDrivenPipeline::SafeDownCast(self->GetExecutive());
  return std::max(self->GetMTime(), executive ? executive->GetPipelineMTime() : 0);
}

}

void ReportError(vtkAlgorithm* self, const std::string& message)
{
  SetFailure(self, message);
  const std::string words = std::to_string(LastChange(self)) + ' ' + message;
  const char* last = LastReport()->Get(self->GetInformation());
  if (last && words == last)
  {
    return;
  }
  LastReport()->Set(self->GetInformation(), words);
  vtkErrorWithObjectMacro(self, << Printable(message));
}

}
