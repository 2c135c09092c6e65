#include "Electrostatics/ForceFieldAtoms.h"

#include "Atoms/ChemicalElement.h"
#include "Atoms/MoleculeAtoms.h"
#include "Core/NamedColumns.h"
#include "Core/RangeChecks.h"

#include <vtkCellArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace isthmus
{
namespace
{

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
    copy->InsertNextTuple(static_cast<vtkIdType>(atom.SourceAtom), array);
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

vtkSmartPointer<vtkPointSet> CopyAtomsWithCharges(
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
  vtkFieldData* const data = result->GetPointData();
  AddComputedColumn<vtkDoubleArray>(
    data, arrays.Charge, protein.Atoms, [](Atom a) { return a.Charge; });
  AddComputedColumn<vtkDoubleArray>(
    data, arrays.Radius, protein.Atoms, [](Atom a) { return a.Radius; });
  AddComputedColumn<vtkStringArray>(data, "AtomName", protein.Atoms, [](Atom a) { return a.Name; });
  AddComputedColumn<vtkUnsignedShortArray>(data, "Element", protein.Atoms,
    [](Atom a) { return static_cast<unsigned short>(ElementFromAtomName(a.Name, a.Residue)); });
  AddComputedColumn<vtkIdTypeArray>(data, "InputAtom", protein.Atoms,
    [](Atom a) { return a.IsNew ? -1 : static_cast<vtkIdType>(a.SourceAtom); });
  for (const char* name : { "ResidueName", "ResidueId", "Chain", "InsertionCode", "IsHetero" })
  {
    CopyColumn(protein, name, atoms, result);
  }
  return result;
}

namespace
{

/// Heavy atoms of the amino acids, that of the end of a chain not counted; 0: another residue.
int CountHeavyAtoms(const std::string& residue)
{
  static const std::map<std::string, int> counts{ { "ALA", 5 }, { "ARG", 11 }, { "ASN", 8 },
    { "ASP", 8 }, { "CYS", 6 }, { "GLN", 9 }, { "GLU", 9 }, { "GLY", 4 }, { "HIS", 10 },
    { "ILE", 8 }, { "LEU", 8 }, { "LYS", 9 }, { "MET", 8 }, { "PHE", 11 }, { "PRO", 7 },
    { "SER", 6 }, { "THR", 7 }, { "TRP", 14 }, { "TYR", 12 }, { "VAL", 7 } };
  const auto found = counts.find(residue);
  return found == counts.end() ? 0 : found->second;
}

}

std::vector<ChargedAtom> PolymerWithoutCharges(vtkPointSet* atoms)
{
  constexpr double radius = 2.0; // of the largest heavy atoms in force fields
  constexpr double reach = 9.0;  // of a side chain that is rebuilt: arginine's, from CA
  PolymerOptions charged;        // free amino acids, which the program charges, count as ligands
  charged.Hydrogens = charged.Ions = charged.Ligands = charged.ProstheticGroups = true;
  const std::vector<NamedAtom> named = ReadNamedAtoms(atoms);
  const auto residueOf = [](const NamedAtom& atom)
  { return std::make_tuple(atom.Chain, atom.ResidueId, atom.InsertionCode, atom.Residue); };
  std::map<decltype(residueOf(named[0])), int> heavy;
  const std::vector<std::size_t> kept = ChoosePolymer(named, charged).Kept;
  for (const std::size_t i : kept)
  {
    heavy[residueOf(named[i])] += named[i].Element != 1 ? 1 : 0;
  }
  std::vector<ChargedAtom> polymer;
  for (const std::size_t i : kept)
  {
    const bool isRebuilt =
      named[i].Name == "CA" && heavy[residueOf(named[i])] < CountHeavyAtoms(named[i].Residue);
    polymer.push_back({ named[i].Place, 0.0, isRebuilt ? reach : radius });
  }
  return polymer;
}

namespace
{

/// One value for each atom; empty without such an array.
std::vector<double> ReadValues(vtkPointSet* atoms, const char* name)
{
  vtkDataArray* array = atoms->GetPointData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < atoms->GetNumberOfPoints(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

std::vector<LigandAtom> ReadLigands(vtkPointSet* ligands)
{
  std::vector<LigandAtom> atoms;
  if (!ligands || ligands->GetNumberOfPoints() == 0)
  {
    return atoms;
  }
  const std::vector<double> charges = ReadValues(ligands, "Charge");
  const std::vector<double> radii = ReadValues(ligands, "Radius");
  if (std::none_of(charges.begin(), charges.end(), [](double q) { return std::isfinite(q); }))
  {
    throw std::invalid_argument("The second input has no charges: open a MOL2 or PQR file there.");
  }
  const std::vector<NamedAtom> named = ReadNamedAtoms(ligands);
  for (std::size_t i = 0; i < named.size(); ++i)
  {
    constexpr double usual = 1.7; // where the input has no radii
    atoms.push_back(
      { named[i], charges[i], i < radii.size() && std::isfinite(radii[i]) ? radii[i] : usual });
  }
  return atoms;
}

}

vtkPointSet* ForceFieldAtomsCache::Get(vtkPointSet* atoms, vtkPointSet* ligands,
  const ChargeArrays& arrays, const ChargeOptions& options, const ProgressCallback& progress)
{
  Check(options);
  const Outcome& outcome =
    this->Cache.Get({ GetState(atoms), GetState(ligands), arrays.Charge, arrays.Radius,
                      options.Table, options.UsePropka, options.PH },
      [&]
      {
        Outcome made;
        try
        {
          const std::vector<LigandAtom> charged = ReadLigands(ligands);
          const std::vector<NamedAtom> named = ReadNamedAtoms(atoms);
          ChargedProtein protein = ChargeProtein(named, options, {}, progress);
          const std::size_t without = protein.Uncharged.size();
          AddLigandCharges(named, charged, protein);
          made.Warning = protein.Warning;
          if (!charged.empty() && protein.Uncharged.size() == without)
          {
            made.Warning += (made.Warning.empty() ? "" : " ") +
              std::string("The second input has charges for none of the residues without charges, "
                          "neither by place nor by the names of residues and atoms.");
          }
          const std::string missing =
            DescribeUncharged(named, ReadValues(atoms, arrays.Charge.c_str()), protein);
          made.Warning += (made.Warning.empty() || missing.empty() ? "" : " ") + missing;
          made.Notes = protein.Notes;
          made.Atoms = CopyAtomsWithCharges(protein, atoms, arrays);
        }
        catch (const Cancelled&)
        {
          throw;
        }
        catch (const std::exception& error)
        {
          made.Failure = error.what();
        }
        return made;
      });
  if (!outcome.Atoms)
  {
    throw std::runtime_error(outcome.Failure);
  }
  return outcome.Atoms;
}

}
