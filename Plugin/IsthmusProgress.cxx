#include "IsthmusProgress.h"

#include <pqApplicationCore.h>
#include <pqCoreUtilities.h>
#include <pqPipelineSource.h>
#include <pqProgressManager.h>
#include <pqServerManagerModel.h>

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkOutputWindow.h>
#include <vtkSMProxy.h>

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QStatusBar>
#include <QThread>
#include <QToolButton>

namespace
{

/// The event of messages.step(), sent to VTK's output window. Its data is a text.
constexpr unsigned long StepEvent = vtkCommand::UserEvent + 100;
/// The event of messages.begin_showing(), in the same way.
constexpr unsigned long ShowsEvent = StepEvent + 1;

constexpr int Interval = 50; // ms, at least, from one reading of events to the next

bool IsInput(QEvent::Type type)
{
  switch (type)
  {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::Shortcut:
    case QEvent::ShortcutOverride:
    case QEvent::ContextMenu:
    case QEvent::DragEnter:
    case QEvent::Drop:
    case QEvent::Close:
    case QEvent::StatusTip: // would be drawn over the text
      return true;
    default:
      return false;
  }
}

}

IsthmusProgress& IsthmusProgress::Instance()
{
  // Lives as long as the application, which it uses in the destructor.
  static IsthmusProgress* const instance = new IsthmusProgress;
  return *instance;
}

void IsthmusProgress::Begin(const QString& title)
{
  this->Title = title;
  this->Runs = true;
  this->CanCancel = true;
  this->IsCancelled = false;
  this->ShowBar();
  vtkOutputWindow* window = vtkOutputWindow::GetInstance();
  this->Watched.emplace_back(window, window->AddObserver(StepEvent, this, &IsthmusProgress::Step));
  this->Watched.emplace_back(
    window, window->AddObserver(ShowsEvent, this, &IsthmusProgress::Shows));
  QObject::connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::sourceAdded, this, &IsthmusProgress::Watch);
  // ParaView blocks the mouse while a filter reports progress, and from version 6 on reads events
  // then, in which presses of Cancel would be lost; eventFilter() blocks it here.
  this->WasUnblocked = pqApplicationCore::instance()->getProgressManager()->unblockEvents(true);
  qApp->installEventFilter(this);
  this->ReadEvents();
}

void IsthmusProgress::End()
{
  qApp->removeEventFilter(this);
  pqApplicationCore::instance()->getProgressManager()->unblockEvents(this->WasUnblocked);
  QObject::disconnect(
    pqApplicationCore::instance()->getServerManagerModel(), nullptr, this, nullptr);
  for (const auto& [object, observer] : this->Watched)
  {
    if (object)
    {
      object->RemoveObserver(observer);
    }
  }
  this->Watched.clear();
  if (this->Bar)
  {
    this->Bar->hide();
  }
  this->Runs = false;
}

void IsthmusProgress::ShowBar()
{
  auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
  if (!window)
  {
    return;
  }
  if (!this->Bar)
  {
    auto* bar = new QWidget(window->statusBar());
    bar->setObjectName("IsthmusProgress");
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    auto* cancel = new QToolButton(bar);
    cancel->setObjectName("IsthmusCancel");
    cancel->setText(tr("Cancel"));
    cancel->setToolTip(tr("Cancels the operation and removes what it has created (Escape)"));
    QObject::connect(
      cancel, &QToolButton::clicked, this, [this] { this->IsCancelled = this->CanCancel; });
    this->Text = new QLabel(bar);
    row->addWidget(cancel); // first, so that it stays in its place
    row->addWidget(this->Text);
    this->Cancel = cancel;
    this->Bar = bar;
    window->statusBar()->insertWidget(0, bar);
  }
  if (auto* note = window->findChild<QLabel*>("IsthmusNote"))
  {
    note->setText({}); // of what was done before
    note->setToolTip({});
  }
  window->statusBar()->clearMessage(); // the tip of the button that was pressed
  this->Text->setText(this->Title);
  this->Cancel->setEnabled(true);
  this->Bar->show();
}

// Sources of the built-in server have their filter in this process.
void IsthmusProgress::Watch(pqPipelineSource* source)
{
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(source->getProxy()->GetClientSideObject()))
  {
    for (const unsigned long event : { vtkCommand::StartEvent, vtkCommand::ProgressEvent })
    {
      this->Watched.emplace_back(
        algorithm, algorithm->AddObserver(event, this, &IsthmusProgress::Progress));
    }
  }
}

// Returns whether the user has cancelled, which InvokeEvent returns to Python.
bool IsthmusProgress::Step(vtkObject*, unsigned long, void* text)
{
  const QString step = QString::fromUtf8(static_cast<const char*>(text));
  if (!step.isEmpty() && this->Text)
  {
    this->Text->setText(this->Title + ": " + step);
  }
  this->ReadEvents();
  return this->IsCancelled;
}

// Filters that show the result must not be aborted: vtkExtractSelection ends ParaView if its input
// was.
void IsthmusProgress::Shows(vtkObject*, unsigned long, void*)
{
  this->CanCancel = false;
  this->IsCancelled = false;
  if (this->Cancel)
  {
    this->Cancel->setEnabled(false);
  }
}

void IsthmusProgress::Progress(vtkObject* object, unsigned long, void*)
{
  if (QThread::currentThread() != this->thread())
  {
    return;
  }
  if (this->SinceEvents.elapsed() >= Interval)
  {
    this->ReadEvents();
  }
  if (this->IsCancelled)
  {
    vtkAlgorithm::SafeDownCast(object)->SetAbortExecuteAndUpdateTime();
  }
}

// Without timers, which would act on filters that are not yet complete.
void IsthmusProgress::ReadEvents()
{
  if (this->ReadsEvents)
  {
    return;
  }
  this->ReadsEvents = true;
  QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::X11ExcludeTimers);
  this->SinceEvents.start();
  this->ReadsEvents = false;
}

bool IsthmusProgress::eventFilter(QObject* object, QEvent* event)
{
  // A modal dialog opened meanwhile needs input; Qt itself blocks all other windows.
  if (!IsInput(event->type()) || QApplication::activeModalWidget())
  {
    return false;
  }
  const bool isKey = event->type() == QEvent::KeyPress;
  if (isKey && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
  {
    this->IsCancelled = this->CanCancel;
    return true;
  }
  // The window passes the mouse on to the widget below it.
  const bool isMouseOfWindow = !isKey && object->isWindowType() && event->type() != QEvent::Close;
  return !isMouseOfWindow && object != this->Cancel;
}
