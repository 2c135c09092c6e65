#include "MolecularSurfaces/DispersionAtoms.h"

#include "Core/NumberText.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{

std::vector<DispersionAtom> MakeDispersionAtoms(vtkDataObject* input, const MoleculeAtoms& atoms)
{
  std::vector<DispersionAtom> result;
  if (atoms.Balls.empty())
  {
    return result;
  }
  vtkDataArray* depths = AtomData(input)->GetArray("WellDepth");
  const std::vector<int> elements = depths ? std::vector<int>() : AtomElements(input);
  if (!depths && elements.empty())
  {
    throw std::invalid_argument(
      "The solvent's attraction needs a point array WellDepth (kcal/mol, "
      "from a force field) or Element of the atoms, and they have neither.");
  }
  for (std::size_t i = 0; i < atoms.Balls.size(); ++i)
  {
    const Ball& ball = atoms.Balls[i];
    const vtkIdType id = atoms.Points[i];
    if (depths)
    {
      const double depth = depths->GetComponent(id, 0);
      if (!(depth >= 0.0) || std::isinf(depth))
      {
        throw std::invalid_argument("Atom " + std::to_string(id) + " has a WellDepth of " +
          FormatNumber(depth) + ", but it is the depth of a well: give 0 or more, in kcal/mol.");
      }
      result.push_back({ ball.Center, ball.Radius, depth });
      continue;
    }
    const auto [radius, depth] = ElementDispersion(elements[static_cast<std::size_t>(id)]);
    result.push_back({ ball.Center, radius, depth });
  }
  return result;
}

}
