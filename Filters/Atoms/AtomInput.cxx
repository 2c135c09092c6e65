#include "Atoms/AtomInput.h"

#include "Atoms/ChemicalElement.h"
#include "Core/RangeChecks.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

vtkStringArray* TextsOf(vtkPointSet* input, const char* name)
{
  return vtkStringArray::SafeDownCast(input->GetPointData()->GetAbstractArray(name));
}

/// An array of one number for each atom; none where it has several.
vtkDataArray* NumbersOf(vtkPointSet* input, const char* name)
{
  vtkDataArray* array = input->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}

template <typename Member>
void TakeTexts(vtkPointSet* input, const char* name, Member member, std::vector<NamedAtom>& atoms)
{
  if (vtkStringArray* array = TextsOf(input, name))
  {
    for (std::size_t i = 0; i < atoms.size(); ++i)
    {
      atoms[i].*member = array->GetValue(static_cast<vtkIdType>(i));
    }
  }
}

template <typename Take>
void TakeNumbers(vtkPointSet* input, const char* name, std::size_t count, Take take)
{
  if (vtkDataArray* array = NumbersOf(input, name))
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      take(i, array->GetComponent(static_cast<vtkIdType>(i), 0));
    }
  }
}

/// The reader's array of radii, which filters look for by themselves.
constexpr const char* DefaultRadii = "Radius";

/// The array of that name; null where it is not there and need not.
vtkDataArray* RadiiOf(const std::string& name, vtkPointSet* input, bool canDoWithout)
{
  vtkDataArray* radii = input->GetPointData()->GetArray(name.c_str());
  if (radii && radii->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("The array of radii has several components, but one number for "
                                "each atom is needed: extract one component first.");
  }
  if (!radii && !canDoWithout)
  {
    throw std::invalid_argument("The atoms have no point array " + name +
      " of radii, and no array Element to look them up by: read them with vtkMacromoleculeReader, "
      "or choose an array.");
  }
  return radii;
}

}

std::vector<NamedAtom> NamedAtomsOf(vtkPointSet* input)
{
  std::vector<NamedAtom> atoms(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), atoms[i].Place.data());
    if (!std::isfinite(atoms[i].Place[0] + atoms[i].Place[1] + atoms[i].Place[2]))
    {
      throw std::invalid_argument(
        "Atom " + std::to_string(i) + " has a coordinate that is no finite number.");
    }
  }
  TakeTexts(input, "AtomName", &NamedAtom::Name, atoms);
  TakeTexts(input, "ResidueName", &NamedAtom::Residue, atoms);
  TakeTexts(input, "Chain", &NamedAtom::Chain, atoms);
  TakeTexts(input, "InsertionCode", &NamedAtom::InsertionCode, atoms);
  TakeTexts(input, "AltLoc", &NamedAtom::AltLoc, atoms);
  const std::size_t n = atoms.size();
  TakeNumbers(input, "ResidueId", n,
    [&](std::size_t i, double value) { atoms[i].ResidueId = static_cast<int>(value); });
  TakeNumbers(input, "Element", n,
    [&](std::size_t i, double value)
    { atoms[i].Element = value >= 0.0 && value < NumberOfElements ? static_cast<int>(value) : 0; });
  TakeNumbers(input, "Occupancy", n,
    [&](std::size_t i, double value) { atoms[i].Occupancy = std::isnan(value) ? 1.0 : value; });
  TakeNumbers(
    input, "IsHetero", n, [&](std::size_t i, double value) { atoms[i].IsHetero = value != 0.0; });
  return atoms;
}

std::string InputArrayName(vtkAlgorithm* filter, int index)
{
  const char* name = filter->GetInputArrayInformation(index)->Get(vtkDataObject::FIELD_NAME());
  return name ? name : "";
}

std::set<std::string> NamesIn(const std::string& list)
{
  constexpr const char* separators = " ,;\t\n";
  std::set<std::string> names;
  for (std::size_t at = list.find_first_not_of(separators); at != std::string::npos;)
  {
    const std::size_t end = std::min(list.find_first_of(separators, at), list.size());
    names.insert(list.substr(at, end - at));
    at = list.find_first_not_of(separators, end);
  }
  return names;
}

ChosenAtoms ChooseAtoms(const std::string& radiusArray, vtkPointSet* input,
  const PolymerOptions& options, WithoutRadii withoutRadii)
{
  ChosenAtoms chosen;
  chosen.Named = NamedAtomsOf(input);
  chosen.HasNames = TextsOf(input, "ResidueName") != nullptr;
  chosen.HasElements = NumbersOf(input, "Element") != nullptr;
  auto* mesh = vtkPolyData::SafeDownCast(input);
  chosen.IsSurface = withoutRadii == WithoutRadii::SurfacePoints && !chosen.HasElements && mesh &&
    mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0;
  vtkDataArray* radii = RadiiOf(radiusArray, input, chosen.HasElements || chosen.IsSurface);
  if (!radii && chosen.HasElements && !radiusArray.empty() && radiusArray != DefaultRadii)
  {
    chosen.Warnings.push_back("There is no point array " + radiusArray +
      " of radii: van der Waals radii (Bondi) were taken. Choose another array.");
  }
  PolymerChoice choice = ChoosePolymer(chosen.Named, options);
  chosen.Notes = std::move(choice.Notes);
  std::size_t without = 0;
  for (const std::size_t i : choice.Kept)
  {
    const NamedAtom& atom = chosen.Named[i];
    const double radius = radii ? radii->GetComponent(static_cast<vtkIdType>(i), 0)
      : chosen.IsSurface        ? 0.0
                                : VanDerWaalsRadius(atom.Element, RadiusTable::Bondi);
    if (std::isnan(radius))
    {
      ++without;
      continue;
    }
    if (!(radius >= 0.0 && radius < 1000.0))
    {
      throw std::invalid_argument("Atom " + std::to_string(i) + " has the radius " +
        FormatNumber(radius) + ", but a radius in angstrom lies between 0 and 1000.");
    }
    chosen.Balls.push_back({ atom.Place, radius });
    chosen.Points.push_back(static_cast<vtkIdType>(i));
  }
  if (without > 0)
  {
    chosen.Warnings.push_back(std::to_string(without) +
      " atoms have no radius and were left out: choose another table of radii in the reader.");
  }
  return chosen;
}

void AddNotes(const std::vector<std::string>& notes, vtkDataObject* to)
{
  vtkNew<vtkStringArray> array;
  array->SetName("Notes");
  for (const std::string& note : notes)
  {
    array->InsertNextValue(note);
  }
  to->GetFieldData()->AddArray(array);
}

}
