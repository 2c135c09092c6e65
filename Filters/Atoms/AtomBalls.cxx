#include "Atoms/AtomBalls.h"

#include "Atoms/AtomInput.h"
#include "Atoms/ChemicalElement.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkInformation.h>
#include <vtkMolecule.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

double RadiusOfElement(int element)
{
  const double radius = VanDerWaalsRadius(element, RadiusTable::Bondi);
  return std::isnan(radius) ? VanDerWaalsRadius(element, RadiusTable::Alvarez) : radius;
}

std::string ArrayNames(vtkDataSetAttributes* data)
{
  std::string names;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArrayName(i);
    names += std::string(" ") + (name ? name : "(unnamed)");
  }
  return names.empty() ? " none" : names;
}

std::vector<double> RadiiOf(vtkDataObject* atoms, const char* name, bool& byElement)
{
  vtkDataArray* array = name ? AtomData(atoms)->GetArray(name) : nullptr;
  const vtkIdType count = AtomPoints(atoms)->GetNumberOfPoints();
  std::vector<double> radii(static_cast<std::size_t>(count));
  byElement = array == nullptr;
  if (array)
  {
    if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() < count)
    {
      throw std::invalid_argument("The array " + std::string(name) +
        " of radii does not have one number for each atom: extract one component first.");
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      radii[static_cast<std::size_t>(i)] = array->GetComponent(i, 0);
    }
    return radii;
  }
  const std::vector<int> elements = AtomElements(atoms);
  if (elements.empty())
  {
    throw std::invalid_argument("The atoms have no point array " + std::string(name ? name : "") +
      " of radii, and no array Element either; they have:" + ArrayNames(AtomData(atoms)) +
      ". Read them with vtkMacromoleculeReader, or choose one of these.");
  }
  std::transform(elements.begin(), elements.end(), radii.begin(), RadiusOfElement);
  return radii;
}

void CheckBall(const Ball& ball, vtkIdType atom)
{
  if (!std::isfinite(ball.Centre[0]) || !std::isfinite(ball.Centre[1]) ||
    !std::isfinite(ball.Centre[2]) || std::isinf(ball.Radius) || ball.Radius < 0.0)
  {
    throw std::invalid_argument("Atom " + std::to_string(atom) +
      " has a coordinate or radius that is not finite, or a negative radius: correct it or leave "
      "it "
      "out.");
  }
}

/// The points that count: all where residues have no names.
PolymerChoice PointsThatCount(vtkDataObject* atoms, const AtomChoice& choice)
{
  PolymerChoice points;
  auto* named = vtkPointSet::SafeDownCast(atoms);
  if (!named || !named->GetPointData()->GetAbstractArray("ResidueName"))
  {
    points.Kept.resize(static_cast<std::size_t>(AtomPoints(atoms)->GetNumberOfPoints()));
    std::iota(points.Kept.begin(), points.Kept.end(), std::size_t{ 0 });
    return points;
  }
  PolymerOptions all;
  all.Hydrogens = all.Ions = all.Ligands = all.ProstheticGroups = true;
  all.Waters = choice.KeepWaters;
  points = ChoosePolymer(NamedAtomsOf(named), all);
  if (points.Kept.empty())
  {
    throw std::invalid_argument(
      "All atoms are water, which is left out: switch KeepWaters on to have its surface.");
  }
  return points;
}

bool AreOfTable(
  const std::vector<double>& radii, const std::vector<int>& elements, RadiusTable table)
{
  constexpr double rounding = 1e-5; // of radii kept as floats
  for (std::size_t i = 0; i < radii.size(); ++i)
  {
    const double expected = VanDerWaalsRadius(elements[i], table);
    if (!std::isnan(radii[i]) && !(std::abs(radii[i] - expected) < rounding))
    {
      return false;
    }
  }
  return true;
}

/// Gives radii by element those of united atoms, where hydrogens are missing.
void UniteAtoms(const PolymerChoice& points, const std::vector<int>& elements,
  std::vector<double>& radii, AtomBalls& result)
{
  const bool hydrogens = std::any_of(points.Kept.begin(), points.Kept.end(),
    [&elements](std::size_t i) { return elements[i] == 1; });
  if (hydrogens ||
    !(result.ByElement || AreOfTable(radii, elements, RadiusTable::Bondi) ||
      AreOfTable(radii, elements, RadiusTable::Alvarez)))
  {
    return;
  }
  for (const std::size_t i : points.Kept)
  {
    const double united = VanDerWaalsRadius(elements[i], RadiusTable::UnitedAtom);
    radii[i] = std::isnan(united) ? radii[i] : united;
  }
  result.Notes.emplace_back("There are no hydrogens, so carbon, nitrogen, oxygen, phosphorus and "
                            "sulphur have the radii of united atoms: switch UnitedAtoms off for "
                            "those of the input.");
}

}

vtkPoints* AtomPoints(vtkDataObject* atoms)
{
  if (auto* molecule = vtkMolecule::SafeDownCast(atoms))
  {
    return molecule->GetAtomicPositionArray();
  }
  auto* points = vtkPointSet::SafeDownCast(atoms);
  return points ? points->GetPoints() : nullptr;
}

vtkDataSetAttributes* AtomData(vtkDataObject* atoms)
{
  if (auto* molecule = vtkMolecule::SafeDownCast(atoms))
  {
    return molecule->GetVertexData();
  }
  return vtkPointSet::SafeDownCast(atoms)->GetPointData();
}

std::vector<int> AtomElements(vtkDataObject* atoms)
{
  std::vector<int> elements;
  vtkDataArray* array = AtomData(atoms)->GetArray("Element");
  if (auto* molecule = vtkMolecule::SafeDownCast(atoms))
  {
    array = molecule->GetAtomicNumberArray();
  }
  if (array && array->GetNumberOfComponents() == 1)
  {
    const vtkIdType count = AtomPoints(atoms)->GetNumberOfPoints(); // the array may be longer
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double element = array->GetComponent(i, 0);
      const bool known = element >= 0.0 && element < NumberOfElements;
      elements.push_back(known ? static_cast<int>(element) : 0);
    }
  }
  return elements;
}

AtomBalls BallsOf(vtkDataObject* atoms, const char* name, const AtomChoice& choice)
{
  AtomBalls result;
  vtkPoints* places = AtomPoints(atoms);
  result.NumberOfAtoms = places ? places->GetNumberOfPoints() : 0;
  if (result.NumberOfAtoms == 0)
  {
    return result;
  }
  std::vector<double> radii = RadiiOf(atoms, name, result.ByElement);
  const PolymerChoice points = PointsThatCount(atoms, choice);
  result.Notes = points.Notes;
  const std::vector<int> elements = AtomElements(atoms);
  if (choice.UnitedAtoms && points.AnyChain && elements.size() == radii.size())
  {
    UniteAtoms(points, elements, radii, result);
  }
  for (const std::size_t i : points.Kept)
  {
    const auto point = static_cast<vtkIdType>(i);
    Ball ball{ {}, radii[i] };
    places->GetPoint(point, ball.Centre.data());
    if (std::isnan(ball.Radius))
    {
      ++result.WithoutRadius;
      continue;
    }
    CheckBall(ball, point);
    result.Points.push_back(point);
    if (ball.Radius > 0.0)
    {
      result.Balls.push_back(ball);
      result.Ids.push_back(point);
    }
  }
  if (result.Balls.empty())
  {
    throw std::invalid_argument("None of the " + std::to_string(result.NumberOfAtoms) +
      " atoms has a radius above 0, so there is nothing to make a surface of: choose another table "
      "of radii in the reader, or another array.");
  }
  return result;
}

AtomBalls BallsOf(vtkAlgorithm* filter, vtkDataObject* atoms, const AtomChoice& choice)
{
  vtkInformation* radii = filter->GetInputArrayInformation(0);
  return BallsOf(atoms, radii ? radii->Get(vtkDataObject::FIELD_NAME()) : nullptr, choice);
}

}
