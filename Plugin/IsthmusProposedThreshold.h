/**
 * @file IsthmusProposedThreshold.h
 * @brief A button beside Minimum Persistence that takes over the threshold that a result proposes.
 *
 * In a panel: `<PropertyWidgetDecorator type="isthmus_proposed_threshold"/>` among the hints of the
 * property. What it does is isthmus_pipelines.use_proposed_threshold().
 */
#ifndef IsthmusProposedThreshold_h
#define IsthmusProposedThreshold_h

#include <pqPropertyWidgetDecorator.h>

class IsthmusProposedThreshold : public pqPropertyWidgetDecorator
{
  Q_OBJECT

public:
  IsthmusProposedThreshold(vtkPVXMLElement* xml, pqPropertyWidget* parent);
};

#endif
