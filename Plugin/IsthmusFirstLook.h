/**
 * @file IsthmusFirstLook.h
 * @brief Sets the initial display of our filters' results, as far as XML cannot.
 *
 * Follows the representations of the window and has pipelines.first_look set colours and
 * their range, tubes and opacity; a filter that waits for its first Apply gets values of the data
 * by first_values. Reports what is selected by selection_changed. What the user has changed stays
 * as it is.
 */
#ifndef IsthmusFirstLook_h
#define IsthmusFirstLook_h

#include <QElapsedTimer>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QSet>
#include <QStringList>

class pqDataRepresentation;
class pqOutputPort;
class pqPipelineSource;
class pqRepresentation;
class vtkObject;

class IsthmusFirstLook : public QObject
{
  Q_OBJECT

public:
  explicit IsthmusFirstLook(QObject* parent = nullptr);

  void Start();
  void Stop();

private:
  void Follow(pqRepresentation* representation);
  void ScheduleLook(pqDataRepresentation* representation);
  void SetFirstValues(pqPipelineSource* source);
  void ScheduleForget();
  void FollowSelection(pqOutputPort* port);
  void Look();
  void CollectNotes(pqPipelineSource* source);
  void CollectNote(vtkObject* window, unsigned long event, void* text);
  void ScheduleNotes(const QStringList& notes);

  QStringList Notes; ///< to be shown soon
  bool NotesWait = false;
  QList<unsigned int> Selected; ///< global ids of sources whose selection is to be followed
  QElapsedTimer SinceButton;    ///< the note of a button, which notes of its filters do not hide
  QSet<pqDataRepresentation*> Waiting; ///< taken out when they are destroyed
  bool Forgets = false;
};

#endif
