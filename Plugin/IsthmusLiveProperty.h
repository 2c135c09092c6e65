/**
 * @file IsthmusLiveProperty.h
 * @brief Property widgets whose changes act without Apply: the thresholds of cached results.
 *
 *     <PropertyWidgetDecorator type="isthmus_live" most="NumberOfFeatures"/>
 *
 * A change is applied within a tenth of a second, while the mouse is still down; further ones are
 * collected until then. Other changes that wait for Apply keep waiting. Nothing is applied before
 * the first Apply.
 *
 * `most`: the slider's maximum is the field data array of that name in the last result; integer
 * sliders start at 1. With `when`, the name of a property: only while that property is not 0.
 *
 * `preview="level"`, for the level of a map: while the slider is held, its contour is drawn instead
 * of the filter's result and of all that depends on it, which are made when the slider is released.
 */
#ifndef IsthmusLiveProperty_h
#define IsthmusLiveProperty_h

#include <pqPropertyWidgetDecorator.h>

#include <QPointer>

class pqPipelineSource;
class QTimer;

class IsthmusLiveProperty : public pqPropertyWidgetDecorator
{
  Q_OBJECT

public:
  IsthmusLiveProperty(vtkPVXMLElement* xml, pqPropertyWidget* parent);

private:
  void Changed();
  void Finished();
  void Preview();
  void Apply();
  void FitSlider(const QString& most, const QString& when);

  QPointer<pqPipelineSource> Source;
  QTimer* Timer;
  bool IsAlone = false; ///< nothing else waits for Apply
  bool IsHeld = false;  ///< there is a preview
};

#endif
