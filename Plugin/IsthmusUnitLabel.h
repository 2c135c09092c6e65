/**
 * @file IsthmusUnitLabel.h
 * @brief The unit of a property behind its label in the panel.
 *
 * Among the hints of the property, in a panel:
 *
 *     <PropertyWidgetDecorator type="isthmus_unit" unit="mV"/>
 *
 * With `when`, the name of a property: the unit is `other` while that property is not 0.
 *
 * The label of the property itself has no unit, since ParaView makes its name in scripts from it.
 */
#ifndef IsthmusUnitLabel_h
#define IsthmusUnitLabel_h

#include <pqPropertyWidgetDecorator.h>

class IsthmusUnitLabel : public pqPropertyWidgetDecorator
{
  Q_OBJECT

public:
  IsthmusUnitLabel(vtkPVXMLElement* xml, pqPropertyWidget* parent);
};

#endif
