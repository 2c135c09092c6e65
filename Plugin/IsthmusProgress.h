/**
 * @file IsthmusProgress.h
 * @brief Progress of a button in the status bar, and its Cancel.
 *
 * A button makes its filters one after the other: messages.step() reports each of them by
 * an event, and the filters report their progress. On each of these the window redraws and
 * processes mouse and keyboard events: only Cancel and Escape take effect, except while a modal
 * dialog is open. Between steps, cancelling works with any server; within a filter only with the
 * built-in one, whose filters are asked to abort. Once the result is being shown, a button cannot
 * be cancelled.
 */
#ifndef IsthmusProgress_h
#define IsthmusProgress_h

#include <vtkWeakPointer.h>

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>
#include <QString>

#include <utility>
#include <vector>

class pqPipelineSource;
class QLabel;
class QWidget;
class vtkAlgorithm;
class vtkObject;

class IsthmusProgress : public QObject
{
  Q_OBJECT

public:
  static IsthmusProgress& Instance();

  /// From here to End() a button runs; `title` is its name.
  void Begin(const QString& title);
  void End();
  bool IsRunning() const { return this->Runs; }

protected:
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  IsthmusProgress() = default;

  void ShowBar();
  void Watch(pqPipelineSource* source);
  bool Step(vtkObject* window, unsigned long event, void* text);
  void Shows(vtkObject* window, unsigned long event, void* unused);
  void Progress(vtkObject* algorithm, unsigned long event, void* fraction);
  void ReadEvents();

  QString Title;
  QPointer<QWidget> Bar; ///< in the status bar: the button, then the text
  QPointer<QWidget> Cancel;
  QPointer<QLabel> Text;
  QElapsedTimer SinceEvents;
  std::vector<std::pair<vtkWeakPointer<vtkObject>, unsigned long>> Watched; ///< with its observer
  bool Runs = false;
  bool CanCancel = false;
  bool IsCancelled = false;
  bool ReadsEvents = false;
  bool WasUnblocked = false; ///< ParaView's events, before Begin()
};

#endif
