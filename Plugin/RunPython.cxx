#include "RunPython.h"

#include <pqUndoStack.h>

#include <vtkPythonInterpreter.h>

namespace isthmus
{

void RunPipelines(const QString& call)
{
  if (!vtkPythonInterpreter::IsInitialized())
  {
    vtkPythonInterpreter::Initialize();
  }
  // The package lies beside the plugin (IsthmusInitialization.cxx).
  const QString statement =
    "import paraview.simple\nimport isthmus_plugin.pipelines\nisthmus_plugin.pipelines." + call +
    '\n';
  // Undone piece by piece, what a script has built comes apart, and a table's view that is taken
  // back ends ParaView 5.11.
  SCOPED_UNDO_EXCLUDE();
  vtkPythonInterpreter::RunSimpleString(statement.toUtf8().constData());
}

}
