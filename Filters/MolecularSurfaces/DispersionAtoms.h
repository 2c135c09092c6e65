/**
 * @file DispersionAtoms.h
 * @brief Lennard-Jones parameters of the atoms of a VTK data set.
 */
#ifndef isthmus_DispersionAtoms_h
#define isthmus_DispersionAtoms_h

#include "Atoms/MoleculeAtoms.h"
#include "MolecularSurfaces/Dispersion.h"

#include <vector>

class vtkDataObject;

namespace isthmus
{

/**
 * One for each ball, in their order. From the point array `WellDepth` (kcal/mol) with the balls'
 * radii as half the minimum's distance, as force fields list them; where it is not there, both by
 * element. Throws std::invalid_argument where there are neither, or a depth is negative or not
 * finite.
 */
std::vector<DispersionAtom> DispersionAtomsOf(vtkDataObject* input, const MoleculeAtoms& atoms);

}

#endif
