#include "IsthmusLiveProperty.h"

#include "RunPython.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqPropertyWidget.h>
#include <pqServerManagerModel.h>

#include <vtkPVArrayInformation.h>
#include <vtkPVDataInformation.h>
#include <vtkPVDataSetAttributesInformation.h>
#include <vtkPVXMLElement.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMProxy.h>
#include <vtkSMSourceProxy.h>
#include <vtkSMUncheckedPropertyHelper.h>

#include <QTimer>

#include <algorithm>

namespace
{

constexpr int Delay = 100; // ms

}

IsthmusLiveProperty::IsthmusLiveProperty(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : pqPropertyWidgetDecorator(xml, parent)
  , Source(pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      parent->proxy()))
  , Timer(new QTimer(this))
{
  if (!this->Source)
  {
    return;
  }
  this->Timer->setSingleShot(true);
  this->Timer->setInterval(Delay);
  QObject::connect(parent, &pqPropertyWidget::changeAvailable, this, [this] { this->Changed(); });
  if (QString(xml->GetAttributeOrEmpty("preview")) == "level")
  {
    QObject::connect(this->Timer, &QTimer::timeout, this, [this] { this->Preview(); });
    QObject::connect(parent, &pqPropertyWidget::changeFinished, this, [this] { this->Finished(); });
  }
  else
  {
    QObject::connect(this->Timer, &QTimer::timeout, this, [this] { this->Apply(); });
  }
  const QString most = xml->GetAttributeOrEmpty("most");
  const QString when = xml->GetAttributeOrEmpty("when");
  if (!most.isEmpty())
  {
    QObject::connect(this->Source.data(),
      QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), this,
      [this, most, when] { this->FitSlider(most, when); });
    // ParaView sets up the widget after its decorators.
    QTimer::singleShot(0, this, [this, most, when] { this->FitSlider(most, when); });
  }
}

void IsthmusLiveProperty::Changed()
{
  if (!this->Source || this->Source->modifiedState() == pqProxy::UNINITIALIZED)
  {
    return;
  }
  if (!this->Timer->isActive())
  {
    if (!this->IsHeld)
    {
      this->IsAlone = this->Source->modifiedState() == pqProxy::UNMODIFIED;
    }
    this->Timer->start();
  }
}

void IsthmusLiveProperty::Preview()
{
  const double level = vtkSMUncheckedPropertyHelper(this->parentWidget()->property()).GetAsDouble();
  this->IsHeld = true;
  isthmus::RunPipelines(QString("preview_level(%1, %2)")
                          .arg(this->Source->getProxy()->GetGlobalID())
                          .arg(level, 0, 'g', 17));
}

void IsthmusLiveProperty::Finished()
{
  if (!this->Source || !(this->IsHeld || this->Timer->isActive()))
  {
    return; // nothing has changed, or it waits for the first Apply
  }
  this->Timer->stop();
  // After ParaView has processed the value.
  QTimer::singleShot(0, this,
    [this]
    {
      isthmus::RunPipelines(
        QString("end_preview(%1)").arg(this->Source->getProxy()->GetGlobalID()));
      this->IsHeld = false;
      this->Apply();
    });
}

void IsthmusLiveProperty::Apply()
{
  if (!this->Source)
  {
    return;
  }
  this->parentWidget()->apply();
  this->Source->getProxy()->UpdateVTKObjects();
  this->Source->updatePipeline();
  isthmus::RunPipelines(QString("live_change(%1)").arg(this->Source->getProxy()->GetGlobalID()));
  this->Source->renderAllViews();
  if (this->IsAlone)
  {
    this->Source->setModifiedState(pqProxy::UNMODIFIED);
  }
}

void IsthmusLiveProperty::FitSlider(const QString& most, const QString& when)
{
  auto* proxy = this->Source ? vtkSMSourceProxy::SafeDownCast(this->Source->getProxy()) : nullptr;
  vtkPVArrayInformation* field = proxy && this->Source->modifiedState() != pqProxy::UNINITIALIZED
    ? proxy->GetDataInformation(0)->GetFieldDataInformation()->GetArrayInformation(
        most.toUtf8().constData())
    : nullptr;
  if (!field ||
    (!when.isEmpty() && vtkSMPropertyHelper(proxy, when.toUtf8().constData()).GetAsInt() == 0))
  {
    return;
  }
  const double largest = field->GetComponentFiniteRange(0)[1];
  for (QWidget* slider : this->parentWidget()->findChildren<QWidget*>())
  {
    if (slider->inherits("pqIntRangeWidget"))
    {
      slider->setProperty("minimum", 1);
      slider->setProperty(
        "maximum", std::max({ 2, slider->property("value").toInt(), static_cast<int>(largest) }));
    }
    else if (slider->inherits("pqDoubleRangeWidget") && largest > 0.0)
    {
      slider->setProperty("maximum", std::max(slider->property("value").toDouble(), largest));
    }
  }
}
