#include "Atoms/PeriodicCell.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <stdexcept>

namespace isthmus
{

PeriodicCell ReadPeriodicCell(vtkDataObject* input, std::vector<std::string>& warnings)
{
  constexpr double thinnest = 1.0; // angstrom
  vtkDataArray* array = input->GetFieldData()->GetArray("CellVectors");
  if (!array || array->GetNumberOfTuples() != 3 || array->GetNumberOfComponents() != 3)
  {
    throw std::invalid_argument(
      "The atoms have no periodic cell (field array CellVectors, the vectors a, b and c): read a "
      "file that has one (CIF, mmCIF, PDB with CRYST1, GRO, extended XYZ), and no assembly of it.");
  }
  std::vector<Point3> vectors(3);
  for (std::size_t k = 0; k < 3; ++k)
  {
    array->GetTuple(static_cast<vtkIdType>(k), vectors[k].data());
  }
  const double volume = std::fabs(Dot(vectors[0], Cross(vectors[1], vectors[2])));
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double face = Length(Cross(vectors[(k + 1) % 3], vectors[(k + 2) % 3]));
    if (!std::isfinite(volume) || !(volume >= thinnest * face) || !(face > 0.0))
    {
      throw std::invalid_argument("The periodic cell (field array CellVectors) is not finite, or "
                                  "thinner than 1 angstrom: correct the cell of the file.");
    }
  }
  auto* group = vtkStringArray::SafeDownCast(input->GetFieldData()->GetAbstractArray("SpaceGroup"));
  std::string name = group && group->GetNumberOfValues() > 0 ? group->GetValue(0) : "";
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  if (!name.empty() && name != "P1")
  {
    warnings.push_back("The space group of the file is " + group->GetValue(0) +
      ": if its atoms are the asymmetric unit only, most atoms of the cell are missing here. Write "
      "all of them as P 1 (VESTA, Mercury, gemmi) and read that file.");
  }
  return PeriodicCell(vectors);
}

}
