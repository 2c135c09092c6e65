/**
 * @file IsthmusPanelButton.h
 * @brief A button beside a property that sets it to the value proposed by the last result.
 *
 * In a panel, among the hints of the property:
 *
 *     <PropertyWidgetDecorator type="isthmus_button" name="UseProposedThreshold"
 *       call="use_proposed_threshold" icon=":/Isthmus/Diagram.svg" title="..." tip="..."/>
 *
 * A click runs pipelines.<call>(global id of the proxy). With `field="NAME"` the button is visible
 * only while the result has field data of that name, and shows its title.
 */
#ifndef IsthmusPanelButton_h
#define IsthmusPanelButton_h

#include <pqPropertyWidgetDecorator.h>

class IsthmusPanelButton : public pqPropertyWidgetDecorator
{
  Q_OBJECT

public:
  IsthmusPanelButton(vtkPVXMLElement* xml, pqPropertyWidget* parent);
};

#endif
