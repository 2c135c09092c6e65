#include "IsthmusPanelButton.h"

#include "RunPython.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqPropertyWidget.h>
#include <pqServerManagerModel.h>

#include <vtkPVDataInformation.h>
#include <vtkPVDataSetAttributesInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMProxy.h>
#include <vtkSMSourceProxy.h>

#include <QBoxLayout>
#include <QIcon>
#include <QToolButton>

namespace
{

/// Whether the result of a source has field data of that name.
bool HasField(const pqPipelineSource* source, const QString& name)
{
  auto* proxy = vtkSMSourceProxy::SafeDownCast(source->getProxy());
  return proxy &&
    proxy->GetDataInformation(0)->GetFieldDataInformation()->GetArrayInformation(
      name.toUtf8().constData());
}

/// Shows the button while the result of `proxy` has the field data.
void FollowField(QToolButton* button, vtkSMProxy* proxy, const QString& name)
{
  auto* source =
    pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(proxy);
  if (!source)
  {
    button->hide();
    return;
  }
  const auto follow = [button, source, name] { button->setVisible(HasField(source, name)); };
  QObject::connect(
    source, QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), button, follow);
  if (source->modifiedState() == pqProxy::UNINITIALIZED)
  {
    button->hide(); // there is no result yet
  }
  else
  {
    follow();
  }
}

}

IsthmusPanelButton::IsthmusPanelButton(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : pqPropertyWidgetDecorator(xml, parent)
{
  auto* row = qobject_cast<QBoxLayout*>(parent->layout());
  if (!row)
  {
    return;
  }
  const auto attribute = [xml](const char* name)
  { return QString(xml->GetAttributeOrEmpty(name)); };
  auto* button = new QToolButton(parent);
  button->setIcon(QIcon(attribute("icon")));
  button->setText(attribute("title"));
  button->setAccessibleName(attribute("title"));
  button->setObjectName(attribute("name"));
  button->setToolTip(attribute("tip"));
  const QString field = attribute("field");
  // A title would not fit beside slider and number.
  button->setToolButtonStyle(
    field.isEmpty() ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon);
  row->insertWidget(0, button); // at the right end a narrow panel hides it
  const QString call = attribute("call") + QString("(%1)").arg(parent->proxy()->GetGlobalID());
  QObject::connect(button, &QToolButton::clicked, this, [call] { isthmus::RunPipelines(call); });
  if (!field.isEmpty())
  {
    FollowField(button, parent->proxy(), field);
  }
}
