#include "vtkAtomSelection.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Core/GatherRanks.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkAtomSelection);

const std::vector<isthmus::OutputArray>& vtkAtomSelection::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "what was dropped, one message for each kind" },
  };
  return table;
}

namespace
{

using isthmus::NamedAtom;
using isthmus::PolymerChoice;
using isthmus::PolymerOptions;

/// The atoms of `choice` that `options` keeps in addition to the chains.
std::vector<std::size_t> NonPolymerAtoms(
  const std::vector<NamedAtom>& atoms, const PolymerOptions& options, const PolymerChoice& choice)
{
  PolymerOptions chains;
  chains.Hydrogens = options.Hydrogens;
  std::vector<std::size_t> rest;
  const std::vector<std::size_t> polymer = isthmus::ChoosePolymer(atoms, chains).Kept;
  std::set_difference(choice.Kept.begin(), choice.Kept.end(), polymer.begin(), polymer.end(),
    std::back_inserter(rest));
  const auto isNamed = [&](std::size_t i) { return options.Residues.count(atoms[i].Residue) > 0; };
  std::vector<std::size_t> named, both;
  std::copy_if(polymer.begin(), polymer.end(), std::back_inserter(named), isNamed);
  std::merge(rest.begin(), rest.end(), named.begin(), named.end(), std::back_inserter(both));
  return both;
}

/// The points, with their arrays. Returns the new id of each old one, -1: dropped.
std::vector<vtkIdType> CopyPoints(
  vtkPointSet* atoms, const std::vector<std::size_t>& kept, vtkPointSet* output)
{
  std::vector<vtkIdType> placeOf(static_cast<std::size_t>(atoms->GetNumberOfPoints()), -1);
  const auto count = static_cast<vtkIdType>(kept.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(atoms->GetPoints()->GetDataType());
  isthmus::SizePoints(points, count);
  vtkPointData* data = output->GetPointData();
  data->CopyAllOn(); // global and pedigree ids as well
  data->CopyAllocate(atoms->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto from = static_cast<vtkIdType>(kept[static_cast<std::size_t>(i)]);
    points->SetPoint(i, atoms->GetPoint(from));
    data->CopyData(atoms->GetPointData(), from, i);
    placeOf[static_cast<std::size_t>(from)] = i;
  }
  output->SetPoints(points);
  return placeOf;
}

/// The cells whose points are all kept; their numbers in the input, from `first`, go to `kept`.
vtkSmartPointer<vtkCellArray> CopyKeptCells(
  vtkCellArray* cells, const std::vector<vtkIdType>& placeOf, vtkIdType first, vtkIdList* kept)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  isthmus::ReserveCells(result, cells->GetNumberOfCells(), cells->GetNumberOfConnectivityIds());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, ids);
    bool whole = true;
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType place = placeOf[static_cast<std::size_t>(ids->GetId(k))];
      whole = whole && place >= 0;
      ids->SetId(k, place);
    }
    if (whole)
    {
      result->InsertNextCell(ids);
      kept->InsertNextId(first + cell);
    }
  }
  return result;
}

void CopyCells(vtkPolyData* atoms, const std::vector<vtkIdType>& placeOf, vtkPolyData* output)
{
  vtkNew<vtkIdList> kept;
  const vtkIdType lines = atoms->GetNumberOfVerts();
  const vtkIdType polygons = lines + atoms->GetNumberOfLines();
  const vtkIdType strips = polygons + atoms->GetNumberOfPolys();
  output->SetVerts(CopyKeptCells(atoms->GetVerts(), placeOf, 0, kept));
  output->SetLines(CopyKeptCells(atoms->GetLines(), placeOf, lines, kept));
  output->SetPolys(CopyKeptCells(atoms->GetPolys(), placeOf, polygons, kept));
  output->SetStrips(CopyKeptCells(atoms->GetStrips(), placeOf, strips, kept));
  vtkCellData* data = output->GetCellData();
  data->CopyAllOn();
  data->CopyAllocate(atoms->GetCellData(), kept->GetNumberOfIds());
  data->CopyData(atoms->GetCellData(), kept, vtkIdType(0));
}

}

int vtkAtomSelection::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
      isthmus::RequireOneRank(this, atoms, "atoms");
      if (atoms && atoms->GetNumberOfPoints() > 0)
      {
        this->Select(atoms, vtkPointSet::GetData(outputVector, 0));
      }
    });
}

void vtkAtomSelection::Select(vtkPointSet* atoms, vtkPointSet* output)
{
  PolymerOptions keep;
  keep.Hydrogens = this->IncludeHydrogens;
  keep.Waters = this->IncludeWaters;
  keep.Ions = this->IncludeIons;
  keep.Ligands = this->IncludeLigands;
  keep.ProstheticGroups = this->IncludeProstheticGroups;
  keep.Residues = isthmus::SplitNames(this->IncludeResidues);
  const std::vector<NamedAtom> named = isthmus::ReadNamedAtoms(atoms);
  this->UpdateProgress(0.3);
  PolymerChoice choice = isthmus::ChoosePolymer(named, keep);
  if (!this->IncludeChains)
  {
    choice.Kept = NonPolymerAtoms(named, keep, choice);
    choice.Notes.emplace_back("Chains of amino acids and nucleotides were left out.");
  }
  this->UpdateProgress(0.7);
  const std::vector<vtkIdType> placeOf = CopyPoints(atoms, choice.Kept, output);
  auto* polygons = vtkPolyData::SafeDownCast(atoms);
  if (polygons && vtkPolyData::SafeDownCast(output))
  {
    CopyCells(polygons, placeOf, vtkPolyData::SafeDownCast(output));
  }
  output->GetFieldData()->PassData(atoms->GetFieldData());
  isthmus::AddNotes(choice.Notes, output);
}

void vtkAtomSelection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IncludeChains: " << this->IncludeChains << "\n";
  os << indent << "IncludeLigands: " << this->IncludeLigands << "\n";
  os << indent << "IncludeProstheticGroups: " << this->IncludeProstheticGroups << "\n";
  os << indent << "IncludeIons: " << this->IncludeIons << "\n";
  os << indent << "IncludeWaters: " << this->IncludeWaters << "\n";
  os << indent << "IncludeHydrogens: " << this->IncludeHydrogens << "\n";
  os << indent << "IncludeResidues: " << this->IncludeResidues << "\n";
}
