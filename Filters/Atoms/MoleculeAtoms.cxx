#include "Atoms/MoleculeAtoms.h"

#include "Atoms/ChemicalElement.h"
#include "Core/NamedColumns.h"
#include "Core/RangeChecks.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkMolecule.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace isthmus
{
namespace
{

vtkStringArray* FindTexts(vtkDataObject* input, const char* name)
{
  return vtkStringArray::SafeDownCast(AtomData(input)->GetAbstractArray(name));
}

/// The array if it has one component, otherwise null.
vtkDataArray* FindNumbers(vtkDataObject* input, const char* name)
{
  vtkDataArray* array = AtomData(input)->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 ? array : nullptr;
}

template <typename Member>
void ReadTexts(vtkDataObject* input, const char* name, Member member, std::vector<NamedAtom>& atoms)
{
  if (vtkStringArray* array = FindTexts(input, name))
  {
    for (std::size_t i = 0; i < atoms.size(); ++i)
    {
      atoms[i].*member = array->GetValue(static_cast<vtkIdType>(i));
    }
  }
}

template <typename Take>
void ReadNumbers(vtkDataObject* input, const char* name, std::size_t count, Take take)
{
  if (vtkDataArray* array = FindNumbers(input, name))
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      take(i, array->GetComponent(static_cast<vtkIdType>(i), 0));
    }
  }
}

bool IsFinite(const std::array<double, 3>& x)
{
  return std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]);
}

[[noreturn]] void RejectCoordinate(std::size_t atom)
{
  throw std::invalid_argument("Atom " + std::to_string(atom) +
    " has a coordinate that is not finite: correct it, or remove the atom.");
}

void CheckBall(const Ball& ball, std::size_t atom, double maximum)
{
  if (!IsFinite(ball.Center))
  {
    RejectCoordinate(atom);
  }
  if (!(ball.Radius >= 0.0) || std::isinf(ball.Radius))
  {
    throw std::invalid_argument("The radius of atom " + std::to_string(atom) + " is " +
      FormatNumber(ball.Radius) +
      ", but a radius is a finite length of 0 or more: correct it, or remove the atom.");
  }
  if (ball.Radius >= maximum)
  {
    throw std::invalid_argument("The radius of atom " + std::to_string(atom) + " is " +
      FormatNumber(ball.Radius) + ", but radii in angstrom are below " + FormatNumber(maximum) +
      ": choose another array.");
  }
}

/// Whether it is a mesh, whose points are not atoms.
bool HasPolygons(vtkDataObject* input)
{
  auto* mesh = vtkPolyData::SafeDownCast(input);
  return mesh && mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips() > 0;
}

/// The atoms to use, by the names of their residues.
PolymerChoice Select(vtkDataObject* input, const AtomOptions& options, MoleculeAtoms& atoms)
{
  PolymerChoice choice;
  if (!options.Selection)
  {
    choice.Kept.resize(static_cast<std::size_t>(atoms.NumberOfAtoms));
    std::iota(choice.Kept.begin(), choice.Kept.end(), std::size_t{ 0 });
    return choice;
  }
  atoms.Named = ReadNamedAtoms(input);
  choice = ChoosePolymer(atoms.Named, *options.Selection);
  // Without this, the message would be that no atom has a radius.
  if (choice.Kept.empty() && options.RequireBalls && !options.Selection->Waters)
  {
    throw std::invalid_argument(
      "All atoms are water, which is dropped: switch IncludeWaters on to include it.");
  }
  return choice;
}

/// Drops atoms of residues with a confidence below `minimum`.
void RemoveUncertain(double minimum, MoleculeAtoms& atoms, PolymerChoice& choice)
{
  RequireRange("MinimumConfidence", minimum, 0.0, 100.0);
  if (minimum == 0.0 || atoms.Named.empty())
  {
    return;
  }
  const std::size_t before = choice.Kept.size();
  const auto isUncertain = [&](std::size_t i) { return atoms.Named[i].Confidence < minimum; };
  const bool hasAny = std::any_of(atoms.Named.begin(), atoms.Named.end(),
    [](const NamedAtom& atom) { return !std::isnan(atom.Confidence); });
  if (!hasAny)
  {
    atoms.Warnings.emplace_back("MinimumConfidence has no effect: the atoms have no array pLDDT "
                                "(predicted models in mmCIF have).");
    return;
  }
  choice.Kept.erase(
    std::remove_if(choice.Kept.begin(), choice.Kept.end(), isUncertain), choice.Kept.end());
  if (choice.Kept.empty())
  {
    throw std::invalid_argument("No residue has a confidence (pLDDT) of " + FormatNumber(minimum) +
      " or more: lower MinimumConfidence.");
  }
  atoms.Notes.push_back("Atoms of residues with a confidence (pLDDT) below " +
    FormatNumber(minimum) + ", left out: " + std::to_string(before - choice.Kept.size()) + " of " +
    std::to_string(before) + ".");
}

/// Of the atoms `kept`, those that lie exactly at the place of another one with a larger radius, or
/// with an equal radius and a smaller id, in ascending order.
std::vector<std::size_t> FindCopies(
  vtkDataObject* input, const std::vector<std::size_t>& kept, const AtomRadii& radii)
{
  struct Atom
  {
    std::array<double, 3> Place;
    double Radius;
    std::size_t Index;
  };
  std::vector<Atom> atoms;
  for (const std::size_t i : kept)
  {
    Atom atom{ {}, radii.Values[i], i };
    AtomPoints(input)->GetPoint(static_cast<vtkIdType>(i), atom.Place.data());
    if (IsFinite(atom.Place) && atom.Radius >= 0.0) // AddBalls() drops or refuses the others
    {
      atoms.push_back(atom);
    }
  }
  std::sort(atoms.begin(), atoms.end(),
    // By place, then the largest first: the first of each run is the one that stays.
    [](const Atom& a, const Atom& b)
    {
      return a.Place != b.Place ? a.Place < b.Place
        : a.Radius != b.Radius  ? a.Radius > b.Radius
                                : a.Index < b.Index;
    });
  std::vector<std::size_t> copies;
  for (std::size_t k = 1; k < atoms.size(); ++k)
  {
    if (atoms[k].Place == atoms[k - 1].Place)
    {
      copies.push_back(atoms[k].Index);
    }
  }
  std::sort(copies.begin(), copies.end());
  return copies;
}

/// Finds and reports the copies, and removes them from `kept` unless they are to be used. A surface
/// is not a molecule, and may have such points.
void RemoveCopies(vtkDataObject* input, const AtomRadii& radii, const AtomOptions& options,
  std::vector<std::size_t>& kept, MoleculeAtoms& atoms)
{
  if (atoms.IsSurface)
  {
    return;
  }
  const std::vector<std::size_t> copies = FindCopies(input, kept, radii);
  if (copies.empty())
  {
    return;
  }
  atoms.Warnings.push_back(std::to_string(copies.size()) + " of " + std::to_string(kept.size()) +
    " atoms lie exactly where another one lies and were left out; of each such group the largest "
    "is used. Does the input contain the molecule twice, for instance in several models?");
  atoms.Copies.assign(copies.begin(), copies.end());
  if (!options.KeepCopies)
  {
    kept.erase(
      std::remove_if(kept.begin(), kept.end(),
        [&copies](std::size_t i) { return std::binary_search(copies.begin(), copies.end(), i); }),
      kept.end());
  }
}

void AddBalls(vtkDataObject* input, const std::vector<std::size_t>& kept, const AtomRadii& radii,
  const AtomOptions& options, MoleculeAtoms& atoms)
{
  vtkPoints* places = AtomPoints(input);
  vtkIdType dropped = 0;
  for (const std::size_t i : kept)
  {
    const auto point = static_cast<vtkIdType>(i);
    Ball ball{ {}, radii.Values[i] };
    places->GetPoint(point, ball.Center.data());
    if (std::isnan(ball.Radius))
    {
      if (options.Missing == MissingRadius::Refuse)
      {
        throw std::invalid_argument("The radius of atom " + std::to_string(i) +
          " is missing (NaN), and the result depends on it: choose another table of radii in the "
          "reader, or another array.");
      }
      ++dropped;
      continue;
    }
    CheckBall(ball, i, options.MaximumRadius);
    atoms.Kept.push_back(point);
    if (ball.Radius > 0.0 || options.ZeroRadii)
    {
      atoms.Balls.push_back(ball);
      atoms.Points.push_back(point);
    }
  }
  if (dropped > 0)
  {
    atoms.Warnings.push_back(std::to_string(dropped) + " of " +
      std::to_string(atoms.NumberOfAtoms) +
      " atoms have no radius and were left out: choose another table of radii in the reader.");
  }
}

}

/// Surfaces and energies include everything that is bound, so only water is dropped.
AtomOptions SelectWholeMolecule(const std::string& radiusArray, bool keepWaters, bool unitedAtoms)
{
  PolymerOptions all;
  all.Hydrogens = all.Ions = all.Ligands = all.ProstheticGroups = true;
  all.Waters = keepWaters;
  AtomOptions options;
  options.RadiusArray = radiusArray;
  options.Selection = all;
  options.UnitedAtoms = unitedAtoms;
  options.RequireBalls = true;
  return options;
}

/// Ligands must not change the pockets that they fill.
AtomOptions SelectPolymer(const std::string& radiusArray, const PolymerOptions& selection)
{
  AtomOptions options;
  options.RadiusArray = radiusArray;
  options.Selection = selection;
  options.ZeroRadii = true;
  options.MaximumRadius = 1000.0; // radii in other units, or an array of something else
  return options;
}

MoleculeAtoms ReadAtoms(vtkDataObject* input, const AtomOptions& options)
{
  MoleculeAtoms atoms;
  vtkPoints* places = AtomPoints(input);
  atoms.NumberOfAtoms = places ? places->GetNumberOfPoints() : 0;
  if (atoms.NumberOfAtoms == 0)
  {
    return atoms;
  }
  const std::vector<int> elements = AtomElements(input);
  atoms.HasNames = FindTexts(input, "ResidueName") != nullptr;
  atoms.HasElements = !elements.empty();
  // A mesh may have points at one place, and no radii: its polygons distinguish it from atoms.
  atoms.IsSurface = options.SurfacePoints && !atoms.HasElements && HasPolygons(input);
  AtomRadii radii = ReadRadii(AtomData(input), atoms.NumberOfAtoms, elements, options.RadiusArray,
    atoms.IsSurface ? RadiusFallback::Zero : options.Fallback);
  if (!radii.Warning.empty())
  {
    atoms.Warnings.push_back(radii.Warning);
  }
  // Before copies are looked for: alternate locations may lie at one place.
  PolymerChoice choice = Select(input, options, atoms);
  atoms.Notes = choice.Notes;
  RemoveUncertain(options.MinimumConfidence, atoms, choice);
  const std::string missing =
    atoms.HasNames ? DescribeMissingSideChains(atoms.Named) : std::string();
  if (!missing.empty())
  {
    atoms.Warnings.push_back(missing);
  }
  if (options.UnitedAtoms && choice.AnyChain && atoms.HasElements &&
    AssignUnitedRadii(choice.Kept, elements, radii))
  {
    atoms.Notes.emplace_back(
      "There are no hydrogens, so carbon, nitrogen, oxygen, phosphorus and sulphur have the radii "
      "of united atoms: switch UnitedAtoms off to use the radii of the input.");
  }
  std::vector<std::size_t> kept = choice.Kept;
  RemoveCopies(input, radii, options, kept, atoms);
  AddBalls(input, kept, radii, options, atoms);
  if (atoms.Balls.empty() && options.RequireBalls)
  {
    throw std::invalid_argument("None of the " + std::to_string(atoms.NumberOfAtoms) +
      " atoms has a radius above 0, so no surface can be computed: choose another table "
      "of radii in the reader, or another array.");
  }
  return atoms;
}

std::vector<double> AtomCharges(
  vtkDataObject* input, const MoleculeAtoms& atoms, const std::string& name)
{
  const std::string advice =
    ". Apply Force Field Charges to the atoms of a PDB or mmCIF file (it needs the program "
    "pdb2pqr), read a PQR file, or choose another array.";
  vtkDataArray* values = AtomData(input)->GetArray(name.c_str());
  if (!values || values->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("The atoms have no point array " + name +
      " with one charge for each; they have:" + ArrayNames(AtomData(input)) + advice);
  }
  const auto unknown = std::count_if(atoms.Kept.begin(), atoms.Kept.end(),
    [&](vtkIdType point) { return std::isnan(values->GetComponent(point, 0)); });
  if (2 * static_cast<std::size_t>(unknown) > atoms.Kept.size())
  {
    // PDB and mmCIF files have no charges, or formal ones of a few atoms only.
    throw std::invalid_argument("The point array " + name + " has no charge for " +
      std::to_string(unknown) + " of " + std::to_string(atoms.Kept.size()) + " atoms" + advice);
  }
  std::vector<double> charges;
  for (const vtkIdType point : atoms.Kept)
  {
    charges.push_back(values->GetComponent(point, 0));
    if (!std::isfinite(charges.back()))
    {
      throw std::invalid_argument("The charge of atom " + std::to_string(point) +
        " is not a finite number: correct it, or remove the atom.");
    }
  }
  return charges;
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
  vtkDataArray* array = FindNumbers(atoms, "Element");
  if (auto* molecule = vtkMolecule::SafeDownCast(atoms))
  {
    array = molecule->GetAtomicNumberArray();
  }
  if (array)
  {
    const vtkIdType count =
      AtomPoints(atoms)->GetNumberOfPoints(); // the array may have more values than there are atoms
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double element = array->GetComponent(i, 0);
      const bool known = element >= 0.0 && element < NumberOfElements;
      elements.push_back(known ? static_cast<int>(element) : 0);
    }
  }
  return elements;
}

std::vector<NamedAtom> ReadNamedAtoms(vtkDataObject* input)
{
  vtkPoints* places = AtomPoints(input);
  std::vector<NamedAtom> atoms(static_cast<std::size_t>(places ? places->GetNumberOfPoints() : 0));
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    places->GetPoint(static_cast<vtkIdType>(i), atoms[i].Place.data());
    if (!IsFinite(atoms[i].Place))
    {
      RejectCoordinate(i);
    }
  }
  ReadTexts(input, "AtomName", &NamedAtom::Name, atoms);
  ReadTexts(input, "ResidueName", &NamedAtom::Residue, atoms);
  ReadTexts(input, "Chain", &NamedAtom::Chain, atoms);
  ReadTexts(input, "InsertionCode", &NamedAtom::InsertionCode, atoms);
  ReadTexts(input, "AltLoc", &NamedAtom::AltLoc, atoms);
  const std::vector<int> elements = atoms.empty() ? std::vector<int>() : AtomElements(input);
  for (std::size_t i = 0; i < elements.size(); ++i)
  {
    atoms[i].Element = elements[i];
  }
  const std::size_t n = atoms.size();
  ReadNumbers(input, "ResidueId", n,
    [&](std::size_t i, double value) { atoms[i].ResidueId = static_cast<int>(value); });
  ReadNumbers(input, "Occupancy", n,
    [&](std::size_t i, double value) { atoms[i].Occupancy = std::isnan(value) ? 1.0 : value; });
  ReadNumbers(input, "pLDDT", n, [&](std::size_t i, double value) { atoms[i].Confidence = value; });
  ReadNumbers(
    input, "IsHetero", n, [&](std::size_t i, double value) { atoms[i].IsHetero = value != 0.0; });
  return atoms;
}

std::string InputArrayName(vtkAlgorithm* filter, int index)
{
  vtkInformation* array = filter->GetInputArrayInformation(index);
  const char* name = array ? array->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  return name ? name : "";
}

std::set<std::string> SplitNames(const std::string& list)
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

void AddNotes(const std::vector<std::string>& notes, vtkDataObject* to)
{
  AddColumn<vtkStringArray>(to->GetFieldData(), "Notes", notes);
}

}
