#include "WindowGuards.h"

#include <pqView.h>

#include <QEvent>
#include <QKeySequence>
#include <QShortcut>
#include <QVariant>
#include <QWidget>

namespace
{

/// The shortcut's property with the button (pqStandardViewFrameActionsImplementation).
constexpr char Button[] = "PV_ACTION";

class EscapeGuard : public QObject
{
public:
  using QObject::QObject;

  bool eventFilter(QObject* object, QEvent* event) override
  {
    auto* shortcut = static_cast<QShortcut*>(object);
    auto* button = event->type() == QEvent::DynamicPropertyChange
      ? shortcut->property(Button).value<QObject*>()
      : nullptr;
    if (button)
    {
      QObject::connect(button, &QObject::destroyed, shortcut,
        [shortcut, button]
        {
          if (shortcut->property(Button).value<QObject*>() == button)
          {
            shortcut->setEnabled(false);
            shortcut->setProperty(Button, QVariant());
          }
        });
    }
    return false;
  }
};

}

namespace isthmus
{

void GuardEscape(QWidget* window)
{
  auto* guard = new EscapeGuard(window);
  for (QShortcut* shortcut : window->findChildren<QShortcut*>())
  {
    if (shortcut->key() == QKeySequence(Qt::Key_Escape))
    {
      shortcut->installEventFilter(guard);
    }
  }
}

void GuardTable(pqView* view)
{
  if (view->getViewType() == "SpreadSheetView" && view->widget())
  {
    QObject::connect(view->widget(), &QObject::destroyed, view,
      [view] { QObject::disconnect(view, SIGNAL(endRender()), view, SLOT(onEndRender())); });
  }
}

}
