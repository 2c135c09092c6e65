/**
 * @file IsthmusToolbar.h
 * @brief The toolbar: each button builds a whole pipeline on the active source.
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
  void Add(const char* function, const char* icon, const QString& text, const QString& tip);
};

#endif
