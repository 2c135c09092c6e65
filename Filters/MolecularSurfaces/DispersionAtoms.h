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
 * The parameters of each ball, in the order of the balls. They are from the point array WellDepth
 * (kcal/mol), with the radii of the balls as half the distance of the minimum, as in force fields;
 * without this array, both are assigned by element. Throws std::invalid_argument if there is
 * neither, or a depth is negative or not finite.
 */
std::vector<DispersionAtom> MakeDispersionAtoms(vtkDataObject* input, const MoleculeAtoms& atoms);

}

#endif
