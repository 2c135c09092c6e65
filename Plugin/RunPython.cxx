#include <vtkPython.h> // before all others

#include "RunPython.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>

#include <vtkPythonInterpreter.h>
#include <vtkSmartPyObject.h>

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
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  const QList<pqPipelineSource*> before = model->findItems<pqPipelineSource*>();
  // Undoing a script's steps one by one breaks its pipeline, and undoing the creation of a table's
  // view crashes ParaView 5.11.
  SCOPED_UNDO_EXCLUDE();
  vtkPythonInterpreter::RunSimpleString(statement.toUtf8().constData());
  for (pqPipelineSource* source : model->findItems<pqPipelineSource*>())
  {
    if (!before.contains(source))
    {
      source->setModifiedState(pqProxy::UNMODIFIED); // there is nothing to apply
    }
  }
}

QString AskPipelines(const QString& call)
{
  RunPipelines("answer = isthmus_plugin.pipelines." + call);
  vtkPythonScopeGilEnsurer gil;
  vtkSmartPyObject module(PyImport_ImportModule("isthmus_plugin.pipelines"));
  vtkSmartPyObject answer(module ? PyObject_GetAttrString(module, "answer") : nullptr);
  const char* text = answer && PyUnicode_Check(answer) ? PyUnicode_AsUTF8(answer) : nullptr;
  PyErr_Clear();
  return text ? QString::fromUtf8(text) : QString();
}

}
