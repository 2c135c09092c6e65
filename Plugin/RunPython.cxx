#include "RunPython.h"

#include <vtkPythonInterpreter.h>

namespace isthmus
{

void RunPipelines(const QString& call)
{
  if (!vtkPythonInterpreter::IsInitialized())
  {
    vtkPythonInterpreter::Initialize();
  }
  // The plugin brings the module with it; ParaView puts it in place when its Python package is
  // read.
  const QString statement =
    "import paraview.simple\nimport isthmus_pipelines\nisthmus_pipelines." + call + '\n';
  vtkPythonInterpreter::RunSimpleString(statement.toUtf8().constData());
}

}
