/**
 * @file IsthmusToolbar.h
 * @brief The toolbar: buttons that build a whole pipeline on the active source, and two that set
 * which choking loops are shown.
 */
#ifndef IsthmusToolbar_h
#define IsthmusToolbar_h

#include <QActionGroup>

class IsthmusToolbar : public QActionGroup
{
  Q_OBJECT

public:
  explicit IsthmusToolbar(QObject* parent);

private:
  QAction* Make(const char* name, const char* icon, const QString& text, const QString& tip);
  /// A button that runs a pipeline, with progress and Cancel.
  void Add(const char* function, const char* icon, const QString& text, const QString& tip);
};

#endif
