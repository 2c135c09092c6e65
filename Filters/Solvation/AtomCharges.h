/**
 * @file AtomCharges.h
 * @brief The charges of a VTK data set's atoms, checked.
 */
#ifndef isthmus_AtomCharges_h
#define isthmus_AtomCharges_h

#include "Atoms/AtomBalls.h"
#include "Electrostatics/PoissonBoltzmannParameters.h"

#include <string>
#include <vector>

namespace isthmus
{

/// One for each of `atoms.Points`, from the point array `name`; radii are left 0.
/// @throws std::invalid_argument where there is no such array of one component, or a charge is not
/// finite.
std::vector<ChargedAtom> AtomChargesOf(
  vtkDataObject* input, const AtomBalls& atoms, const std::string& name);

}

#endif
