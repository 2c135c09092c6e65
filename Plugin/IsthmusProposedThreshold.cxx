#include "IsthmusProposedThreshold.h"

#include "RunPython.h"

#include <vtkSMProxy.h>

#include <QBoxLayout>
#include <QIcon>
#include <QToolButton>

IsthmusProposedThreshold::IsthmusProposedThreshold(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : pqPropertyWidgetDecorator(xml, parent)
{
  auto* row = qobject_cast<QBoxLayout*>(parent->layout());
  if (!row)
  {
    return;
  }
  auto* button = new QToolButton(parent); // a word would not fit beside slider and number
  button->setIcon(QIcon(":/Isthmus/Diagram.svg"));
  button->setAccessibleName(tr("Take the proposed threshold"));
  button->setObjectName("UseProposedThreshold");
  button->setToolTip(
    tr("Take the threshold that the last result proposes: the largest gap of its persistence "
       "diagram, of both sides the lower one."));
  row->insertWidget(0, button); // at the right end a narrow panel hides it
  const QString call = QString("use_proposed_threshold(%1)").arg(parent->proxy()->GetGlobalID());
  QObject::connect(button, &QToolButton::clicked, this, [call] { isthmus::RunPipelines(call); });
}
