/**
 * @file IsthmusLevelHistogram.h
 * @brief Histogram above the slider of a level (hint PropertyWidgetDecorator, type isthmus_level).
 *
 * Shows the values of the map, the level as a line that the mouse moves, and the automatic level as
 * a dashed line. The slider covers the same range. Below it: the level in standard deviations, the
 * volume that it encloses, and where it comes from. A button sets the automatic level; it replaces
 * the one that sets the middle of the range. All values are those of isthmus_plugin.levels.
 */
#ifndef IsthmusLevelHistogram_h
#define IsthmusLevelHistogram_h

#include <pqPropertyWidgetDecorator.h>

#include <QJsonObject>
#include <QPointer>

class QLabel;
class QToolButton;
class QWidget;
class pqPipelineSource;

class IsthmusLevelHistogram : public pqPropertyWidgetDecorator
{
  Q_OBJECT

public:
  IsthmusLevelHistogram(vtkPVXMLElement* xml, pqPropertyWidget* parent);

private:
  void Arrange();
  void ScheduleUpdate();
  void Update();
  void Describe();
  void SetLevel(double level, bool isFinal);
  void Drag(double place, bool isFinal);
  void UseAutomatic();
  double Level() const;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void Paint();

  QPointer<pqPipelineSource> Source;
  QPointer<QWidget> Slider;    ///< with its number
  QPointer<QWidget> Histogram; ///< drawn by Paint()
  QPointer<QToolButton> Automatic;
  QPointer<QLabel> Label;
  QJsonObject Values;
  bool IsStale = false; ///< the values are those of a previous result
};

#endif
