#include "Pockets/PoreOutput.h"

#include "Core/InnerAlgorithm.h"
#include "Core/NamedColumns.h"
#include "Pockets/PoreRadius.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <map>
#include <set>

namespace isthmus
{
namespace
{

/// HOLE's limits, in angstrom: below the first no water passes, above the second two waters side by
/// side.
constexpr double OneWater = 1.15;
constexpr double TwoWaters = 2.30;

/// An atom within this distance of a pore's ball lines it; in angstrom.
constexpr double Reach = 0.5;

/// "TRP 23 A", or the known part of it.
std::string GetResidueName(const MoleculeAtoms& atoms, std::int64_t ball)
{
  if (ball < 0 || !atoms.HasNames)
  {
    return {};
  }
  const auto point = static_cast<std::size_t>(atoms.Points[static_cast<std::size_t>(ball)]);
  const NamedAtom& atom = atoms.Named[point];
  return atom.Residue + " " + std::to_string(atom.ResidueId) + atom.InsertionCode +
    (atom.Chain.empty() ? "" : " " + atom.Chain);
}

/// "SER 54 A; TRP 23 A": the residues with an atom that touches the ball, nearly, in order.
std::string ResiduesAround(
  const PoreSample& sample, const AtomField& field, const MoleculeAtoms& atoms)
{
  std::set<std::string> names;
  for (const std::int64_t atom : field.Touching(sample.Center, sample.Radius + Reach))
  {
    names.insert(GetResidueName(atoms, atom));
  }
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "" : "; ") + name;
  }
  return list;
}

/// The arrays that samples have in all outputs.
class SampleArrays
{
public:
  void Add(int pore, const PoreSample& sample, double radiusError, const MoleculeAtoms& atoms)
  {
    this->PoreId->InsertNextValue(pore);
    this->Radius->InsertNextValue(sample.Radius);
    this->RadiusError->InsertNextValue(radiusError);
    this->ArcLength->InsertNextValue(sample.ArcLength);
    this->Nearest->InsertNextValue(
      sample.NearestAtom < 0 ? -1 : atoms.Points[static_cast<std::size_t>(sample.NearestAtom)]);
    this->Residue->InsertNextValue(GetResidueName(atoms, sample.NearestAtom));
    this->WidthClass->InsertNextValue(
      sample.Radius < OneWater ? 0 : (sample.Radius < TwoWaters ? 1 : 2));
  }

  template <typename AddArray>
  void ForEachArray(AddArray add) const
  {
    for (vtkAbstractArray* array :
      std::initializer_list<vtkAbstractArray*>{ this->PoreId, this->ArcLength, this->Radius,
        this->RadiusError, this->WidthClass, this->Nearest, this->Residue })
    {
      add(array);
    }
  }

private:
  vtkNew<vtkIntArray> PoreId = NamedArray<vtkIntArray>("PoreId");
  vtkNew<vtkDoubleArray> Radius = NamedArray<vtkDoubleArray>("Radius");
  vtkNew<vtkDoubleArray> RadiusError = NamedArray<vtkDoubleArray>("RadiusError");
  vtkNew<vtkDoubleArray> ArcLength = NamedArray<vtkDoubleArray>("ArcLength");
  vtkNew<vtkIdTypeArray> Nearest = NamedArray<vtkIdTypeArray>("NearestAtom");
  vtkNew<vtkStringArray> Residue = NamedArray<vtkStringArray>("NearestResidue");
  vtkNew<vtkIntArray> WidthClass = NamedArray<vtkIntArray>("WidthClass");
};

int PoreNumber(std::size_t pore)
{
  return static_cast<int>(pore) + 1;
}

const PoreSample& Narrowest(const Pore& pore)
{
  return *std::min_element(pore.Samples.begin(), pore.Samples.end(),
    [](const PoreSample& a, const PoreSample& b) { return a.Radius < b.Radius; });
}

}

void FillPoreLines(const PoreReport& report, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  auto poreId = NamedArray<vtkIntArray>("PoreId");
  SampleArrays arrays;
  for (std::size_t p = 0; p < report.Pores.size(); ++p)
  {
    const auto& samples = report.Pores[p].Samples;
    lines->InsertNextCell(static_cast<int>(samples.size()));
    poreId->InsertNextValue(PoreNumber(p));
    for (const PoreSample& sample : samples)
    {
      lines->InsertCellPoint(points->InsertNextPoint(sample.Center.data()));
      arrays.Add(PoreNumber(p), sample, sample.RadiusError, report.Atoms);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->AddArray(poreId);
  arrays.ForEachArray([&](vtkAbstractArray* array) { output->GetPointData()->AddArray(array); });
  output->GetPointData()->SetActiveScalars("Radius");
}

void FillPoreSamples(const PoreReport& report, vtkTable* output)
{
  SampleArrays arrays;
  std::vector<Point3> places;
  for (std::size_t p = 0; p < report.Pores.size(); ++p)
  {
    for (const PoreSample& sample : report.Pores[p].Samples)
    {
      arrays.Add(PoreNumber(p), sample, sample.RadiusError, report.Atoms);
      places.push_back(sample.Center);
    }
  }
  arrays.ForEachArray([&](vtkAbstractArray* array) { output->AddColumn(array); });
  const char* names[] = { "X", "Y", "Z" };
  for (std::size_t k = 0; k < 3; ++k)
  {
    AddComputedColumn<vtkDoubleArray>(
      output->GetRowData(), names[k], places, [k](const Point3& place) { return place[k]; });
  }
}

void FillPoreTable(const PoreReport& report, vtkTable* output)
{
  vtkFieldData* const data = output->GetRowData();
  const auto add = [&](const char* name, const auto& of)
  { AddComputedColumn<vtkDoubleArray>(data, name, report.Pores, of); };
  AddComputedColumn<vtkIntArray>(data, "PoreId", report.Pores.size(), PoreNumber);
  AddComputedColumn<vtkStringArray>(
    data, "Direction", report.Pores, [](const Pore& pore) { return pore.Direction; });
  add("Radius", [](const Pore& pore) { return Narrowest(pore).Radius; });
  add("RadiusError", [](const Pore& pore) { return pore.DipBelowNarrowest(); });
  add("Length", [](const Pore& pore) { return pore.Samples.back().ArcLength; });
  add("Span", [](const Pore& pore) { return pore.Span; });
  add("BottleneckX", [](const Pore& pore) { return Narrowest(pore).Center[0]; });
  add("BottleneckY", [](const Pore& pore) { return Narrowest(pore).Center[1]; });
  add("BottleneckZ", [](const Pore& pore) { return Narrowest(pore).Center[2]; });
  AddComputedColumn<vtkIntArray>(
    data, "Bottlenecks", report.Pores, [](const Pore& pore) { return pore.Bottlenecks.size(); });
}

void FillBottlenecks(const PoreReport& report, vtkPolyData* output)
{
  const AtomField field(report.Atoms.Balls);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  auto rank = NamedArray<vtkIntArray>("Rank");
  auto residues = NamedArray<vtkStringArray>("Residues");
  SampleArrays arrays;
  for (std::size_t p = 0; p < report.Pores.size(); ++p)
  {
    int number = 0;
    for (const std::size_t i : report.Pores[p].Bottlenecks)
    {
      const PoreSample& sample = report.Pores[p].Samples[i];
      const vtkIdType id = points->InsertNextPoint(sample.Center.data());
      vertices->InsertNextCell(1, &id);
      rank->InsertNextValue(++number);
      residues->InsertNextValue(ResiduesAround(sample, field, report.Atoms));
      arrays.Add(PoreNumber(p), sample, Pore::DipBelow(sample), report.Atoms);
    }
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  arrays.ForEachArray([&](vtkAbstractArray* array) { output->GetPointData()->AddArray(array); });
  output->GetPointData()->AddArray(rank);
  output->GetPointData()->AddArray(residues);
  output->GetPointData()->SetActiveScalars("Radius");
}

std::vector<std::vector<LiningResidue>> PoreLining(const PoreReport& report)
{
  std::vector<std::vector<LiningResidue>> residues;
  const AtomField field(report.Atoms.Balls);
  for (const Pore& pore : report.Pores)
  {
    std::vector<char> lines(report.Atoms.Balls.size(), 0);
    for (const PoreSample& sample : pore.Samples)
    {
      for (const std::int64_t atom : field.Touching(sample.Center, sample.Radius + Reach))
      {
        lines[static_cast<std::size_t>(atom)] = 1;
      }
    }
    std::vector<LiningAtom> lining;
    for (std::size_t atom = 0; atom < lines.size(); ++atom)
    {
      if (lines[atom])
      {
        lining.push_back({ static_cast<std::int64_t>(atom), 0.0 });
      }
    }
    residues.push_back(FindLiningResidues(lining, report.Atoms));
  }
  return residues;
}

void FillPoreLining(const PoreReport& report,
  const std::vector<std::vector<LiningResidue>>& residues, vtkTable* output)
{
  LiningTable table("PoreId");
  for (std::size_t p = 0; p < residues.size(); ++p)
  {
    table.Add(PoreNumber(p), residues[p], report.Atoms);
  }
  table.Fill(output);
  output->RemoveColumnByName("Area");
}

void FillPoreLiningAtoms(const PoreReport& report,
  const std::vector<std::vector<LiningResidue>>& residues, vtkPointSet* input, vtkPolyData* output)
{
  ResidueAtoms atoms(report.Atoms, input, "PoreId");
  for (std::size_t p = 0; p < residues.size(); ++p)
  {
    atoms.Add(PoreNumber(p), residues[p]);
  }
  atoms.Fill(output);
}

void FillTubes(vtkPolyData* lines, vtkPolyData* output)
{
  // The filter takes scalars as radii as they are; where atoms overlap the line, there is no tube.
  vtkNew<vtkPolyData> positive;
  positive->ShallowCopy(lines);
  auto width = NamedArray<vtkDoubleArray>("TubeWidth");
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    width->InsertNextValue(
      std::max(0.01, lines->GetPointData()->GetArray("Radius")->GetComponent(i, 0)));
  }
  positive->GetPointData()->AddArray(width);
  positive->GetPointData()->SetActiveScalars("TubeWidth");
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(positive);
  tube->SetVaryRadiusToVaryRadiusByAbsoluteScalar();
  tube->SetNumberOfSides(24);
  UpdateInner(tube);
  output->ShallowCopy(tube->GetOutput());
  output->GetPointData()->RemoveArray("TubeWidth");
  output->GetPointData()->SetActiveScalars("WidthClass");
}

}
