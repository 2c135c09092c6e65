#include "IsthmusUnitLabel.h"

#include <pqPropertyWidget.h>

#include <vtkPVXMLElement.h>
#include <vtkSMProperty.h>

#include <QLabel>
#include <QRegularExpression>
#include <QTimer>

namespace
{

/// Adds the unit to the label of `widget`, which ParaView writes between tags of HTML.
void AddUnit(const pqPropertyWidget* widget, const QString& unit)
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
    if (QString(text).remove(tag).trimmed() == label)
    {
      shown->setText(text.replace(label, label + " (" + unit + ")"));
    }
  }
}

}

IsthmusUnitLabel::IsthmusUnitLabel(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : pqPropertyWidgetDecorator(xml, parent)
{
  const QString unit = xml->GetAttributeOrEmpty("unit");
  // ParaView makes the label after the decorators.
  QTimer::singleShot(0, this, [parent, unit] { AddUnit(parent, unit); });
}
