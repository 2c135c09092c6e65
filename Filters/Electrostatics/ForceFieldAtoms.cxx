#include "Electrostatics/ForceFieldAtoms.h"

#include "Atoms/ChemicalElement.h"
#include "Atoms/MoleculeAtoms.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedShortArray.h>

#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

template <typename Array, typename Value>
void AddColumn(const ChargedProtein& protein, const std::string& name, vtkPointSet* to, Value value)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfValues(static_cast<vtkIdType>(protein.Atoms.size()));
  for (std::size_t i = 0; i < protein.Atoms.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), value(protein.Atoms[i]));
  }
  to->GetPointData()->AddArray(array);
}

/// An array that all atoms of a residue share.
void CopyColumn(const ChargedProtein& protein, const char* name, vtkPointSet* from, vtkPointSet* to)
{
  vtkAbstractArray* array = from->GetPointData()->GetAbstractArray(name);
  if (!array)
  {
    return;
  }
  const auto copy = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  copy->SetName(name);
  copy->SetNumberOfComponents(array->GetNumberOfComponents());
  for (const ForceFieldAtom& atom : protein.Atoms)
  {
    copy->InsertNextTuple(static_cast<vtkIdType>(atom.Like), array);
  }
  to->GetPointData()->AddArray(copy);
}

}

bool LacksCharges(vtkPointSet* atoms, const ChargeArrays& arrays)
{
  vtkPointData* data = atoms->GetPointData();
  if (!vtkStringArray::SafeDownCast(data->GetAbstractArray("AtomName")) ||
    !vtkStringArray::SafeDownCast(data->GetAbstractArray("ResidueName")))
  {
    return false;
  }
  vtkDataArray* charges = data->GetArray(arrays.Charge.c_str());
  vtkIdType missing = 0;
  for (vtkIdType i = 0; charges && i < charges->GetNumberOfTuples(); ++i)
  {
    missing += std::isnan(charges->GetComponent(i, 0)) ? 1 : 0;
  }
  return !charges || 2 * missing > charges->GetNumberOfTuples();
}

vtkSmartPointer<vtkPointSet> PointsOf(
  const ChargedProtein& protein, vtkPointSet* atoms, const ChargeArrays& arrays)
{
  auto result = vtkSmartPointer<vtkPointSet>::Take(atoms->NewInstance());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  for (const ForceFieldAtom& atom : protein.Atoms)
  {
    const vtkIdType id = points->InsertNextPoint(atom.Place.data());
    vertices->InsertNextCell(1, &id);
  }
  result->SetPoints(points);
  if (auto* polygons = vtkPolyData::SafeDownCast(result))
  {
    polygons->SetVerts(vertices);
  }
  using Atom = const ForceFieldAtom&;
  AddColumn<vtkDoubleArray>(protein, arrays.Charge, result, [](Atom a) { return a.Charge; });
  AddColumn<vtkDoubleArray>(protein, arrays.Radius, result, [](Atom a) { return a.Radius; });
  AddColumn<vtkStringArray>(protein, "AtomName", result, [](Atom a) { return a.Name; });
  AddColumn<vtkUnsignedShortArray>(protein, "Element", result,
    [](Atom a) { return static_cast<unsigned short>(ElementOfAtomName(a.Name, a.Residue)); });
  AddColumn<vtkIdTypeArray>(protein, "InputAtom", result,
    [](Atom a) { return a.IsNew ? -1 : static_cast<vtkIdType>(a.Like); });
  for (const char* name : { "ResidueName", "ResidueId", "Chain", "InsertionCode", "IsHetero" })
  {
    CopyColumn(protein, name, atoms, result);
  }
  return result;
}

std::vector<ChargedAtom> PolymerWithoutCharges(vtkPointSet* atoms)
{
  constexpr double radius = 2.0; // of the largest heavy atoms in force fields
  PolymerOptions chains;
  chains.Hydrogens = true;
  const std::vector<NamedAtom> named = NamedAtomsOf(atoms);
  std::vector<ChargedAtom> polymer;
  for (const std::size_t i : ChoosePolymer(named, chains).Kept)
  {
    polymer.push_back({ named[i].Place, 0.0, radius });
  }
  return polymer;
}

vtkPointSet* ForceFieldAtomsCache::Get(vtkPointSet* atoms, const ChargeArrays& arrays,
  ChargeTable table, const ProgressCallback& progress)
{
  const std::string names = arrays.Charge + '\n' + arrays.Radius;
  if (this->Input != atoms || this->Time != atoms->GetMTime() || this->Table != table ||
    this->Names != names)
  {
    this->Input = nullptr; // a stop on request leaves nothing to be taken for an answer
    this->Charged = nullptr;
    this->Failure.clear();
    this->Warned.clear();
    try
    {
      const ChargedProtein protein = ChargeProtein(NamedAtomsOf(atoms), table, {}, progress);
      this->Warned = protein.Warning;
      this->Charged = PointsOf(protein, atoms, arrays);
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const std::exception& error)
    {
      this->Failure = error.what();
    }
    this->Input = atoms;
    this->Time = atoms->GetMTime();
    this->Table = table;
    this->Names = names;
  }
  if (!this->Charged)
  {
    throw std::runtime_error(this->Failure);
  }
  return this->Charged;
}

}
