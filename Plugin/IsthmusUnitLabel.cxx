#include "IsthmusUnitLabel.h"

#include <pqCoreUtilities.h>
#include <pqPropertyWidget.h>

#include <vtkCommand.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProperty.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>

#include <QLabel>
#include <QRegularExpression>
#include <QTimer>

namespace
{

/// Appends the unit to the label of `widget`, which ParaView wraps in HTML tags.
void SetUnit(const pqPropertyWidget* widget, const QString& unit)
{
  const QWidget* panel = widget->parentWidget();
  const QString label = widget->property() ? widget->property()->GetXMLLabel() : "";
  if (!panel || label.isEmpty())
  {
    return;
  }
  const QRegularExpression tag("<[^>]*>");
  for (auto* shown : panel->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly))
  {
    QString text = shown->text();
    const QString words = QString(text).remove(tag).trimmed();
    if (words == label || words.startsWith(label + " ("))
    {
      shown->setText(text.replace(words, label + " (" + unit + ")"));
    }
  }
}

}

IsthmusUnitLabel::IsthmusUnitLabel(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : pqPropertyWidgetDecorator(xml, parent)
{
  const QString unit = QString::fromUtf8(xml->GetAttributeOrEmpty("unit"));
  const QString other = QString::fromUtf8(xml->GetAttributeOrEmpty("other"));
  vtkSMProperty* const when = parent->proxy()->GetProperty(xml->GetAttributeOrEmpty("when"));
  const auto set = [parent, unit, other, when]
  { SetUnit(parent, when && vtkSMPropertyHelper(when).GetAsInt() != 0 ? other : unit); };
  if (when)
  {
    pqCoreUtilities::connect(when, vtkCommand::ModifiedEvent, this, SIGNAL(visibilityChanged()));
    QObject::connect(this, &pqPropertyWidgetDecorator::visibilityChanged, this, set);
  }
  // ParaView makes the label after the decorators.
  QTimer::singleShot(0, this, set);
}
