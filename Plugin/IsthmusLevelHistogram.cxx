#include "IsthmusLevelHistogram.h"

#include "RunPython.h"

#include <pqApplicationCore.h>
#include <pqPipelineSource.h>
#include <pqPropertyWidget.h>
#include <pqServerManagerModel.h>

#include <vtkSMProxy.h>

#include <QAbstractButton>
#include <QBoxLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace
{

constexpr int Height = 64; // pixels

}

IsthmusLevelHistogram::IsthmusLevelHistogram(vtkPVXMLElement* xml, pqPropertyWidget* parent)
  : pqPropertyWidgetDecorator(xml, parent)
  , Source(pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
      parent->proxy()))
{
  for (auto* child : parent->findChildren<QWidget*>())
  {
    if (child->inherits("pqDoubleRangeWidget"))
    {
      this->Slider = child;
    }
  }
  if (!this->Source || !this->Slider)
  {
    return;
  }
  this->Arrange();
  QObject::connect(this->Source.data(),
    QOverload<pqPipelineSource*>::of(&pqPipelineSource::dataUpdated), this,
    &IsthmusLevelHistogram::ScheduleUpdate);
  QObject::connect(parent, &pqPropertyWidget::changeAvailable, this, [this] { this->Describe(); });
  QObject::connect(parent, &pqPropertyWidget::changeFinished, this, [this] { this->Describe(); });
  parent->installEventFilter(this);
  this->ScheduleUpdate();
}

// ParaView sets up the widget after its decorators, and a hidden panel costs nothing.
void IsthmusLevelHistogram::ScheduleUpdate()
{
  this->IsStale = true;
  QTimer::singleShot(0, this,
    [this]
    {
      if (this->IsStale && this->parentWidget()->isVisible())
      {
        this->Update();
      }
    });
}

// The histogram, the row that ParaView has made, and the text, one below the other.
void IsthmusLevelHistogram::Arrange()
{
  auto* box = qobject_cast<QBoxLayout*>(this->parentWidget()->layout());
  if (!box)
  {
    return;
  }
  auto* row = new QHBoxLayout;
  while (QLayoutItem* item = box->takeAt(0))
  {
    if (item->layout())
    {
      item->layout()->setParent(nullptr);
      row->addLayout(item->layout());
      continue;
    }
    row->addItem(item);
  }
  // In its place: it sets the middle of the range, and is drawn only while it is highlighted.
  for (auto* button : this->parentWidget()->findChildren<QAbstractButton*>())
  {
    if (button->inherits("pqHighlightablePushButton") ||
      button->inherits("pqHighlightableToolButton"))
    {
      button->hide();
    }
  }
  this->Automatic = new QToolButton(this->parentWidget());
  this->Automatic->setObjectName("UseAutomaticLevel");
  this->Automatic->setIcon(this->Automatic->style()->standardIcon(QStyle::SP_BrowserReload));
  this->Automatic->setToolTip(tr("Set the automatic level"));
  QObject::connect(
    this->Automatic, &QAbstractButton::clicked, this, &IsthmusLevelHistogram::UseAutomatic);
  row->insertWidget(0, this->Automatic); // at the right end a narrow panel hides it
  box->setDirection(QBoxLayout::TopToBottom);
  this->Histogram = new QWidget(this->parentWidget());
  this->Histogram->setObjectName("LevelHistogram");
  this->Histogram->setFixedHeight(Height);
  this->Histogram->setCursor(Qt::SplitHCursor);
  this->Histogram->setToolTip(tr(
    "Number of nodes with each value (logarithmic). Drag to change the level; the dashed line is "
    "the automatic level."));
  this->Histogram->installEventFilter(this);
  this->Label = new QLabel(this->parentWidget());
  this->Label->setObjectName("LevelText");
  this->Label->setWordWrap(true); // its lines must not make the panel wider than its dock
  this->Label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  this->Label->setToolTip(
    tr("The level in standard deviations of all values from their mean, the volume that it "
       "encloses and its mass at 1.35 g/cm³, and the automatic level with its origin."));
  box->addWidget(this->Histogram);
  box->addLayout(row);
  box->addWidget(this->Label);
  this->Histogram->hide();
  this->Label->hide();
}

void IsthmusLevelHistogram::Update()
{
  if (!this->Histogram || !this->Source || this->Source->modifiedState() == pqProxy::UNINITIALIZED)
  {
    return;
  }
  this->IsStale = false;
  this->Values = QJsonDocument::fromJson(
    isthmus::AskPipelines(QString("level_values(%1)").arg(this->Source->getProxy()->GetGlobalID()))
      .toUtf8())
                   .object();
  this->Histogram->setVisible(!this->Values.isEmpty());
  this->Label->setVisible(!this->Values.isEmpty());
  if (!this->Values.isEmpty())
  {
    // A level outside of the range stays as it is; the slider then reaches to it.
    const double level = this->Level();
    this->Slider->setProperty("minimum", std::min(level, this->Values["low"].toDouble()));
    this->Slider->setProperty("maximum", std::max(level, this->Values["high"].toDouble()));
    this->Describe();
  }
}

double IsthmusLevelHistogram::Level() const
{
  return this->Slider->property("value").toDouble();
}

void IsthmusLevelHistogram::Describe()
{
  if (this->Values.isEmpty())
  {
    return;
  }
  const double level = this->Level(), low = this->Values["low"].toDouble(),
               high = this->Values["high"].toDouble(),
               deviation = this->Values["deviation"].toDouble();
  QStringList parts;
  if (deviation > 0.0)
  {
    parts << tr("mean %1 %2 SD")
               .arg(level < this->Values["mean"].toDouble() ? "−" : "+")
               .arg(std::abs(level - this->Values["mean"].toDouble()) / deviation, 0, 'f', 2);
  }
  const QJsonArray inside = this->Values["inside"].toArray();
  const double place = (level - low) / (high - low) * (inside.size() - 1);
  if (place >= 0.0 && place <= inside.size() - 1)
  {
    const int first = std::min<int>(static_cast<int>(place), inside.size() - 2);
    const double volume = inside[first].toDouble() +
      (place - first) * (inside[first + 1].toDouble() - inside[first].toDouble());
    const double mass = volume * this->Values["protein"].toDouble() / 1000.0; // kDa
    parts << tr("encloses %1 nm³").arg(volume / 1000.0, 0, 'g', 4);
    if (mass > 0.0)
    {
      parts << tr("%1 kDa of protein").arg(mass, 0, 'g', 3);
    }
  }
  const QJsonValue automatic = this->Values["automatic"];
  this->Automatic->setEnabled(false);
  if (automatic.isDouble())
  {
    const double value = automatic.toDouble();
    const bool isUsed = std::abs(level - value) <= 1e-5 * (std::abs(value) + std::abs(high - low));
    parts << (isUsed ? tr("automatic") : tr("automatic: %1").arg(value, 0, 'g', 4))
          << this->Values["source"].toString();
    this->Automatic->setEnabled(!isUsed);
  }
  this->Label->setText(parts.join('\n'));
  this->Histogram->update();
}

void IsthmusLevelHistogram::SetLevel(double level, bool isFinal)
{
  this->Slider->setProperty("value", level);
  if (isFinal)
  {
    QMetaObject::invokeMethod(this->Slider, "valueEdited", Q_ARG(double, level));
  }
}

void IsthmusLevelHistogram::Drag(double place, bool isFinal)
{
  const double low = this->Values["low"].toDouble(), high = this->Values["high"].toDouble();
  const double share = std::clamp(place / std::max(1, this->Histogram->width() - 1), 0.0, 1.0);
  this->SetLevel(low + share * (high - low), isFinal);
}

void IsthmusLevelHistogram::UseAutomatic()
{
  if (this->Values["automatic"].isDouble())
  {
    this->SetLevel(this->Values["automatic"].toDouble(), true);
  }
}

bool IsthmusLevelHistogram::eventFilter(QObject* watched, QEvent* event)
{
  if (watched == this->parentWidget() && event->type() == QEvent::Show && this->IsStale)
  {
    this->ScheduleUpdate();
  }
  if (watched != this->Histogram || this->Values.isEmpty())
  {
    return false;
  }
  const auto* mouse = static_cast<QMouseEvent*>(event);
  switch (event->type())
  {
    case QEvent::Paint:
      this->Paint();
      return true;
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
      this->Drag(mouse->pos().x(), false);
      return true;
    case QEvent::MouseButtonRelease:
      this->Drag(mouse->pos().x(), true);
      return true;
    default:
      return false;
  }
}

void IsthmusLevelHistogram::Paint()
{
  QPainter painter(this->Histogram);
  const QRectF box = this->Histogram->rect();
  const QPalette palette = this->Histogram->palette();
  painter.fillRect(box, palette.base());
  const QJsonArray bars = this->Values["bars"].toArray();
  double most = 1.0;
  for (const QJsonValue& bar : bars)
  {
    most = std::max(most, bar.toDouble());
  }
  const double width = box.width() / std::max<int>(1, bars.size());
  for (int i = 0; i < bars.size(); ++i)
  {
    const double height =
      std::log1p(std::max(0.0, bars[i].toDouble())) / std::log1p(most) * (box.height() - 2.0);
    painter.fillRect(QRectF(i * width, box.height() - height, width, height), palette.mid());
  }
  const double low = this->Values["low"].toDouble(), high = this->Values["high"].toDouble();
  const auto line = [&](double level, const QPen& pen)
  {
    const double x = std::clamp((level - low) / (high - low), 0.0, 1.0) * (box.width() - 1.0);
    painter.setPen(pen);
    painter.drawLine(QPointF(x, 0.0), QPointF(x, box.height()));
  };
  if (this->Values["automatic"].isDouble())
  {
    line(this->Values["automatic"].toDouble(), QPen(palette.text(), 1.0, Qt::DashLine));
  }
  line(this->Level(), QPen(palette.highlight(), 2.0));
}
