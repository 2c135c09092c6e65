#include "IsthmusFirstLook.h"

#include "IsthmusBrowser.h"
#include "IsthmusProgress.h"
#include "RunPython.h"
#include "WindowGuards.h"

#include <pqApplicationCore.h>
#include <pqCoreUtilities.h>
#include <pqDataRepresentation.h>
#include <pqOutputPort.h>
#include <pqPVApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqSelectionManager.h>
#include <pqServer.h>
#include <pqServerManagerModel.h>
#include <pqUndoStack.h>
#include <pqView.h>

#include <vtkCommand.h>
#include <vtkOutputWindow.h>
#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVDataSetAttributesInformation.h>
#include <vtkPVProxyDefinitionIterator.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPropertyIterator.h>
#include <vtkSMProxyDefinitionManager.h>
#include <vtkSMProxyLocator.h>
#include <vtkSMSessionProxyManager.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMUncheckedPropertyHelper.h>
#include <vtkSMVectorProperty.h>
#include <vtkSmartPointer.h>

#include <QLabel>
#include <QMainWindow>
#include <QStatusBar>
#include <QTimer>

namespace
{

/// Delay (ms) of reactions to changes, until the button that makes them has finished.
int PendingDelay()
{
  return IsthmusProgress::Instance().IsRunning() ? 200 : 0;
}

/// Whether a panel has values that wait for Apply.
bool HasEdits(vtkSMProxy* proxy)
{
  const auto properties =
    vtkSmartPointer<vtkSMPropertyIterator>::Take(proxy->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* property = properties->GetProperty();
    if (!vtkSMVectorProperty::SafeDownCast(property))
    {
      continue;
    }
    const vtkSMPropertyHelper values(property, true);
    const vtkSMUncheckedPropertyHelper edited(property, true);
    const unsigned int count = values.GetNumberOfElements();
    if (edited.GetNumberOfElements() != count)
    {
      return true;
    }
    for (unsigned int i = 0; i < count; ++i)
    {
      if (values.GetAsVariant(i) != edited.GetAsVariant(i))
      {
        return true;
      }
    }
  }
  return false;
}

/// Files with capital endings, such as .PDB and .STL, which readers take, but ParaView's dialog
/// does not.
void AcceptCapitals(pqServer* server)
{
  const QStringList own{ "ccp4", "cif", "dx", "ent", "gro", "map", "mrc", "obj", "off", "pdb",
    "ply", "pqr", "stl" };
  const auto sources = vtkSmartPointer<vtkPVProxyDefinitionIterator>::Take(
    server->proxyManager()->GetProxyDefinitionManager()->NewSingleGroupIterator("sources"));
  for (sources->InitTraversal(); !sources->IsDoneWithTraversal(); sources->GoToNextItem())
  {
    vtkPVXMLElement* hints = sources->GetProxyHints();
    vtkPVXMLElement* reader = hints ? hints->FindNestedElementByName("ReaderFactory") : nullptr;
    const QString endings = reader ? reader->GetAttributeOrEmpty("extensions") : "";
    const QStringList all = endings.split(' ');
    QStringList capitals;
    for (const QString& ending : all)
    {
      if (own.contains(ending) && !all.contains(ending.toUpper()))
      {
        capitals << ending.toUpper();
      }
    }
    if (!capitals.isEmpty())
    {
      reader->SetAttribute("extensions", (endings + ' ' + capitals.join(' ')).toUtf8().constData());
    }
  }
}

bool IsReader(vtkSMProxy* proxy)
{
  vtkPVXMLElement* hints = proxy->GetHints();
  return hints && hints->FindNestedElementByName("ReaderFactory");
}

/// The lists of arrays of a panel mark it as modified when ParaView builds it.
void Unmark(pqServerManagerModelItem* item)
{
  const QPointer<pqPipelineSource> source(qobject_cast<pqPipelineSource*>(item));
  if (!source || source->modifiedState() != pqProxy::MODIFIED ||
    !(IsthmusBrowser::IsOurs(source->getProxy()) || IsReader(source->getProxy())))
  {
    return;
  }
  QTimer::singleShot(0, source.data(),
    [source]
    {
      if (source->modifiedState() == pqProxy::MODIFIED && !HasEdits(source->getProxy()))
      {
        source->setModifiedState(pqProxy::UNMODIFIED);
      }
    });
}

}

IsthmusFirstLook::IsthmusFirstLook(QObject* parent)
  : QObject(parent)
{
}

void IsthmusFirstLook::Start()
{
  // Runs before the first look at loaded sources, which is delayed until the event loop.
  const auto keep = [] { isthmus::RunPipelines("keep_looks()"); };
  QObject::connect(pqApplicationCore::instance(), &pqApplicationCore::stateLoaded, this, keep);
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(
    model, &pqServerManagerModel::representationAdded, this, &IsthmusFirstLook::Follow);
  QObject::connect(model, &pqServerManagerModel::viewAdded, this, &isthmus::GuardTable);
  QObject::connect(
    model, &pqServerManagerModel::sourceAdded, this, &IsthmusFirstLook::SetFirstValues);
  QObject::connect(
    model, &pqServerManagerModel::sourceRemoved, this, &IsthmusFirstLook::ScheduleForget);
  QObject::connect(
    model, &pqServerManagerModel::dataUpdated, this, &IsthmusFirstLook::CollectNotes);
  QObject::connect(model, &pqServerManagerModel::modifiedStateChanged, this, Unmark);
  QObject::connect(model, &pqServerManagerModel::serverAdded, this, AcceptCapitals);
  for (pqServer* server : model->findItems<pqServer*>())
  {
    AcceptCapitals(server);
  }
  // A plugin that is loaded automatically starts while the application is still being created.
  QTimer::singleShot(0, this,
    [this, keep]
    {
      vtkOutputWindow::GetInstance()->AddObserver(
        vtkCommand::UserEvent, this, &IsthmusFirstLook::CollectNote);
      if (auto* core = pqPVApplicationCore::instance())
      {
        QObject::connect(core->selectionManager(), &pqSelectionManager::selectionChanged, this,
          &IsthmusFirstLook::FollowSelection);
      }
      if (pqUndoStack* stack = pqApplicationCore::instance()->getUndoStack())
      {
        QObject::connect(stack, &pqUndoStack::undone, this, keep);
        QObject::connect(stack, &pqUndoStack::redone, this, keep);
      }
      if (QWidget* window = pqCoreUtilities::mainWidget())
      {
        isthmus::GuardEscape(window);
      }
    });
}

void IsthmusFirstLook::Stop()
{
  QObject::disconnect(pqApplicationCore::instance(), nullptr, this, nullptr);
  if (pqUndoStack* stack = pqApplicationCore::instance()->getUndoStack())
  {
    QObject::disconnect(stack, nullptr, this, nullptr);
  }
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
  if (auto* core = pqPVApplicationCore::instance())
  {
    QObject::disconnect(core->selectionManager(), nullptr, this, nullptr);
  }
  vtkOutputWindow::GetInstance()->RemoveObservers(vtkCommand::UserEvent);
  this->Waiting.clear();
}

// After ParaView's own windows have processed the selection; before, their contents are not yet
// there. ParaView emits several signals for one click.
void IsthmusFirstLook::FollowSelection(pqOutputPort* port)
{
  const unsigned int id = port ? port->getSource()->getProxy()->GetGlobalID() : 0;
  if (this->Selected.isEmpty())
  {
    QTimer::singleShot(0, this,
      [this]
      {
        QList<unsigned int> ids;
        ids.swap(this->Selected);
        for (const unsigned int each : ids)
        {
          isthmus::RunPipelines(QString("selection_changed(%1)").arg(each));
        }
      });
  }
  this->Selected.removeAll(id);
  this->Selected << id;
}

// A note explains a correct result; the Information panel keeps it as field data.
void IsthmusFirstLook::CollectNotes(pqPipelineSource* source)
{
  constexpr qint64 ofButton = 15000; // ms
  auto* proxy = vtkSMSourceProxy::SafeDownCast(source->getProxy());
  // The panel of Atom Selection already shows what it drops.
  if ((this->SinceButton.isValid() && this->SinceButton.elapsed() < ofButton) ||
    (proxy && QString(proxy->GetXMLName()) == "AtomSelection"))
  {
    return;
  }
  vtkPVArrayInformation* notes = proxy && proxy->GetNumberOfOutputPorts() > 0
    ? proxy->GetDataInformation(0)->GetFieldDataInformation()->GetArrayInformation("Notes")
    : nullptr;
  QStringList texts;
  for (int i = 0; notes && i < notes->GetNumberOfStringValues(); ++i)
  {
    texts << QString::fromUtf8(notes->GetStringValue(i));
  }
  this->ScheduleNotes(texts);
}

// messages.show_note().
void IsthmusFirstLook::CollectNote(vtkObject*, unsigned long, void* text)
{
  this->Notes.clear();
  this->SinceButton.start();
  this->ScheduleNotes({ QString::fromUtf8(static_cast<const char*>(text)) });
}

void IsthmusFirstLook::ScheduleNotes(const QStringList& notes)
{
  constexpr int delay = 200;    // ms, for those of one pipeline together
  constexpr double width = 0.6; // of the window; the tool tip shows long messages in full
  const bool waits = this->NotesWait;
  this->Notes << notes;
  this->Notes.removeAll("");
  this->Notes.removeDuplicates();
  if (waits || this->Notes.isEmpty())
  {
    return;
  }
  this->NotesWait = true;
  QTimer::singleShot(delay, this,
    [this]
    {
      this->NotesWait = false;
      auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
      const QString text = this->Notes.join(' ');
      this->Notes.clear();
      if (window)
      {
        auto* label = window->findChild<QLabel*>("IsthmusNote");
        if (!label)
        {
          label = new QLabel(window->statusBar()); // the next tool tip would erase a message
          label->setObjectName("IsthmusNote");
          window->statusBar()->insertWidget(0, label);
        }
        label->setMaximumWidth(static_cast<int>(width * window->width()));
        label->setText(text);
        label->setToolTip(text);
      }
    });
}

void IsthmusFirstLook::Follow(pqRepresentation* added)
{
  auto* representation = qobject_cast<pqDataRepresentation*>(added);
  if (!representation)
  {
    return;
  }
  const auto look = [this, representation] { this->ScheduleLook(representation); };
  QObject::connect(representation, &pqDataRepresentation::dataUpdated, this, look);
  QObject::connect(representation, &pqDataRepresentation::colorArrayNameModified, this, look);
  QObject::connect(representation, &QObject::destroyed, this,
    [this, representation] { this->Waiting.remove(representation); });
}

// ParaView is still choosing colours when it emits this signal.
void IsthmusFirstLook::ScheduleLook(pqDataRepresentation* representation)
{
  if (this->Waiting.isEmpty())
  {
    QTimer::singleShot(PendingDelay(), this, [this] { this->Look(); });
  }
  this->Waiting.insert(representation);
}

// The menu, or a script that sets its own values, must finish first.
void IsthmusFirstLook::SetFirstValues(pqPipelineSource* source)
{
  QTimer::singleShot(0, source,
    [source]
    {
      if (source->modifiedState() != pqProxy::UNINITIALIZED ||
        IsthmusProgress::Instance().IsRunning())
      {
        return; // from a state file, a script or a button, which has set its values
      }
      const QString id = QString::number(source->getProxy()->GetGlobalID());
      isthmus::RunPipelines("first_values(" + id + ')');
    });
}

// Once for all that are deleted together.
void IsthmusFirstLook::ScheduleForget()
{
  if (this->Forgets)
  {
    return;
  }
  this->Forgets = true;
  QTimer::singleShot(PendingDelay(), this,
    [this]
    {
      this->Forgets = false;
      if (IsthmusProgress::Instance().IsRunning())
      {
        this->ScheduleForget();
        return;
      }
      pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
      if (model->findItems<pqServer*>().isEmpty() || model->findItems<pqView*>().isEmpty())
      {
        return; // the program ends, or the session
      }
      const auto count = [model]
      { return model->findItems<pqPipelineSource*>().size() + model->findItems<pqView*>().size(); };
      const auto before = count();
      isthmus::RunPipelines("forget()");
      if (count() != before)
      {
        CLEAR_UNDO_STACK(); // a restored source would look for its view
      }
    });
}

void IsthmusFirstLook::Look()
{
  // A filter that executes while a state is loaded processes events.
  if (IsthmusProgress::Instance().IsRunning() || pqApplicationCore::instance()->isLoadingState())
  {
    QTimer::singleShot(PendingDelay(), this, [this] { this->Look(); });
    return;
  }
  QStringList ids;
  for (pqDataRepresentation* representation : this->Waiting)
  {
    ids << QString::number(representation->getProxy()->GetGlobalID());
  }
  this->Waiting.clear();
  if (ids.isEmpty())
  {
    return;
  }
  isthmus::RunPipelines("first_look(" + ids.join(", ") + ')');
}
