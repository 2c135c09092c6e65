#include "Pockets/LiningResidues.h"

#include "Core/NamedColumns.h"

#include <vtkCellArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace isthmus
{
namespace
{

const NamedAtom& AtomAt(const MoleculeAtoms& atoms, vtkIdType point)
{
  return atoms.Named[static_cast<std::size_t>(point)];
}

/// For each point, the points connected to it by lines of `input`.
std::vector<std::vector<vtkIdType>> BondedTo(vtkPointSet* input)
{
  std::vector<std::vector<vtkIdType>> bonded;
  if (auto* molecule = vtkPolyData::SafeDownCast(input))
  {
    bonded.resize(static_cast<std::size_t>(molecule->GetNumberOfPoints()));
    vtkNew<vtkIdList> ends;
    for (vtkIdType bond = 0; bond < molecule->GetLines()->GetNumberOfCells(); ++bond)
    {
      molecule->GetLines()->GetCellAtId(bond, ends);
      if (ends->GetNumberOfIds() == 2)
      {
        bonded[static_cast<std::size_t>(ends->GetId(0))].push_back(ends->GetId(1));
      }
    }
  }
  return bonded;
}

/// The atom of a residue that carries its label: CA, otherwise the first; none without names.
vtkIdType LabelledPoint(const MoleculeAtoms& atoms, const std::vector<vtkIdType>& residue)
{
  if (!atoms.HasNames || residue.empty())
  {
    return -1;
  }
  const auto alpha = std::find_if(residue.begin(), residue.end(),
    [&](vtkIdType point) { return AtomAt(atoms, point).Name == "CA"; });
  return alpha != residue.end() ? *alpha : residue.front();
}

}

std::vector<LiningResidue> FindLiningResidues(
  const std::vector<LiningAtom>& lining, const MoleculeAtoms& atoms)
{
  std::map<std::array<std::string, 4>, std::size_t> numbers;
  std::vector<LiningResidue> residues;
  for (const LiningAtom& one : lining)
  {
    const vtkIdType point = atoms.Points[static_cast<std::size_t>(one.Atom)];
    const NamedAtom& atom = AtomAt(atoms, point);
    const std::string number =
      atoms.HasNames ? std::to_string(atom.ResidueId) : "point " + std::to_string(point);
    const auto [at, isNew] = numbers.emplace(
      std::array<std::string, 4>{ atom.Chain, number, atom.InsertionCode, atom.Residue },
      residues.size());
    if (isNew)
    {
      residues.emplace_back();
    }
    residues[at->second].Points.push_back(point);
    residues[at->second].Area += one.Area;
  }
  return residues;
}

std::string MakeResidueLabel(const NamedAtom& atom)
{
  return atom.Residue + " " + std::to_string(atom.ResidueId) + atom.InsertionCode +
    (atom.Chain.empty() ? "" : " ") + atom.Chain;
}

std::string JoinNames(std::vector<LiningResidue> residues, const MoleculeAtoms& atoms)
{
  if (!atoms.HasNames)
  {
    return {};
  }
  std::stable_sort(residues.begin(), residues.end(),
    [](const LiningResidue& a, const LiningResidue& b) { return a.Area > b.Area; });
  std::string text;
  for (const LiningResidue& residue : residues)
  {
    text += (text.empty() ? "" : "; ") + MakeResidueLabel(AtomAt(atoms, residue.Points.front()));
  }
  return text;
}

std::string DescribeConfidence(
  const std::vector<LiningResidue>& residues, const MoleculeAtoms& atoms, const std::string& place)
{
  constexpr double low = 70.0; // "low" and "very low" of AlphaFold's database
  std::size_t known = 0;
  std::size_t uncertain = 0;
  for (const LiningResidue& residue : residues)
  {
    const auto point = static_cast<std::size_t>(residue.Points.front());
    const double confidence =
      point < atoms.Named.size() ? atoms.Named[point].Confidence : std::nan("");
    known += std::isnan(confidence) ? 0 : 1;
    uncertain += confidence < low ? 1 : 0;
  }
  if (uncertain == 0 || 5 * uncertain < known)
  {
    return {};
  }
  return "Of the " + std::to_string(known) + " residues at " + place + ", " +
    std::to_string(uncertain) +
    " have a low confidence (pLDDT below 70), so it may be no more than "
    "a guess: set MinimumConfidence to leave such residues out.";
}

void LiningTable::Add(
  int feature, const std::vector<LiningResidue>& residues, const MoleculeAtoms& atoms)
{
  for (const LiningResidue& residue : residues)
  {
    const NamedAtom& first = AtomAt(atoms, residue.Points.front());
    std::string names;
    std::string ids;
    for (const vtkIdType point : residue.Points)
    {
      names += (names.empty() ? "" : " ") + AtomAt(atoms, point).Name;
      ids += (ids.empty() ? "" : " ") + std::to_string(point);
    }
    this->Rows.push_back({ feature, first, names, ids, residue.Points.size(), residue.Area });
  }
}

void LiningTable::Fill(vtkTable* output) const
{
  using R = const Row&;
  vtkFieldData* const data = output->GetRowData();
  AddComputedColumn<vtkIntArray>(
    data, this->FeatureName, this->Rows, [](R row) { return row.Feature; });
  AddComputedColumn<vtkStringArray>(
    data, "Chain", this->Rows, [](R row) { return row.First.Chain; });
  AddComputedColumn<vtkIntArray>(
    data, "ResidueId", this->Rows, [](R row) { return row.First.ResidueId; });
  AddComputedColumn<vtkStringArray>(
    data, "InsertionCode", this->Rows, [](R row) { return row.First.InsertionCode; });
  AddComputedColumn<vtkStringArray>(
    data, "ResidueName", this->Rows, [](R row) { return row.First.Residue; });
  AddComputedColumn<vtkStringArray>(data, "Atoms", this->Rows, [](R row) { return row.Names; });
  AddComputedColumn<vtkStringArray>(data, "AtomIds", this->Rows, [](R row) { return row.Ids; });
  AddComputedColumn<vtkIntArray>(
    data, "NumberOfAtoms", this->Rows, [](R row) { return row.Count; });
  AddComputedColumn<vtkDoubleArray>(data, "Area", this->Rows, [](R row) { return row.Area; });
}

ResidueAtoms::ResidueAtoms(const MoleculeAtoms& atoms, vtkPointSet* input, const char* featureName)
  : Atoms(atoms)
  , Input(input)
  , Feature(NamedArray<vtkIntArray>(featureName))
  , Label(NamedArray<vtkStringArray>("ResidueLabel"))
{
  for (const vtkIdType point : atoms.Points)
  {
    this->OfResidue[MakeKey(AtomAt(atoms, point))].push_back(point);
  }
}

ResidueAtoms::~ResidueAtoms() = default;

ResidueAtoms::Key ResidueAtoms::MakeKey(const NamedAtom& atom)
{
  return { atom.Chain, std::to_string(atom.ResidueId), atom.InsertionCode, atom.Residue };
}

void ResidueAtoms::Add(int feature, const std::vector<LiningResidue>& residues)
{
  this->FirstOfFeature.push_back(this->Points.size());
  for (const LiningResidue& residue : residues)
  {
    const auto& whole = this->Atoms.HasNames
      ? this->OfResidue.at(MakeKey(AtomAt(this->Atoms, residue.Points.front())))
      : residue.Points;
    const vtkIdType named = LabelledPoint(this->Atoms, whole);
    for (const vtkIdType point : whole)
    {
      this->Points.push_back(point);
      this->Feature->InsertNextValue(feature);
      this->Label->InsertNextValue(
        point == named ? MakeResidueLabel(AtomAt(this->Atoms, point)) : "");
    }
  }
}

void ResidueAtoms::Fill(vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(this->Points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkPointData* data = output->GetPointData();
  data->CopyAllocate(this->Input->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType from = this->Points[static_cast<std::size_t>(i)];
    points->InsertNextPoint(this->Input->GetPoint(from));
    data->CopyData(this->Input->GetPointData(), from, i);
    vertices->InsertNextCell(1, &i);
  }
  vtkNew<vtkCellArray> bonds;
  const auto bonded = BondedTo(this->Input);
  this->FirstOfFeature.push_back(this->Points.size());
  for (std::size_t f = 0; !bonded.empty() && f + 1 < this->FirstOfFeature.size(); ++f)
  {
    std::map<vtkIdType, vtkIdType> place;
    for (std::size_t i = this->FirstOfFeature[f]; i < this->FirstOfFeature[f + 1]; ++i)
    {
      place.emplace(this->Points[i], static_cast<vtkIdType>(i));
    }
    for (const auto& [point, id] : place)
    {
      for (const vtkIdType other : bonded[static_cast<std::size_t>(point)])
      {
        const auto at = place.find(other);
        if (at != place.end())
        {
          const vtkIdType both[2] = { id, at->second };
          bonds->InsertNextCell(2, both);
        }
      }
    }
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->SetLines(bonds);
  data->SetScalars(this->Feature);
  data->AddArray(this->Label);
}

}
