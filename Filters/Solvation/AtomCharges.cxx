#include "Solvation/AtomCharges.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkPoints.h>

#include <cmath>
#include <stdexcept>

namespace isthmus
{

std::vector<ChargedAtom> AtomChargesOf(
  vtkDataObject* input, const AtomBalls& atoms, const std::string& name)
{
  vtkDataArray* values = AtomData(input)->GetArray(name.c_str());
  if (!values || values->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("The atoms have no point array " + name +
      " with one charge for each: read a PQR file (pdb2pqr makes one from a PDB file), or choose "
      "another array.");
  }
  std::vector<ChargedAtom> charges;
  for (const vtkIdType point : atoms.Points)
  {
    ChargedAtom atom{ {}, values->GetComponent(point, 0), 0.0 };
    AtomPoints(input)->GetPoint(point, atom.Position.data());
    if (!std::isfinite(atom.Charge))
    {
      throw std::invalid_argument("The charge of atom " + std::to_string(point) +
        " is not a finite number: correct it or leave the atom out.");
    }
    charges.push_back(atom);
  }
  return charges;
}

}
