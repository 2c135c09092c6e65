#include "vtkPoreProfile.h"

#include "Atoms/MoleculeAtoms.h"
#include "Atoms/PeriodicCell.h"
#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/NamedColumns.h"
#include "Core/RangeChecks.h"
#include "Pockets/LongTriangulation.h"
#include "Pockets/PoreOutput.h"
#include "Pockets/PoreProfile.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkPoreProfile);

namespace
{

double LongestEdge(vtkPolyData* surface)
{
  double longest = 0.0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, corners);
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      double p[2][3];
      surface->GetPoint(corners->GetId(k), p[0]);
      surface->GetPoint(corners->GetId((k + 1) % corners->GetNumberOfIds()), p[1]);
      longest = std::max(longest, vtkMath::Distance2BetweenPoints(p[0], p[1]));
    }
  }
  return std::sqrt(longest);
}

/// The requested pores.
struct PoreQuery
{
  int Mode;
  const double* Point1;
  const double* Point2;
  const double* Point;
  const double* Direction;
};

std::vector<isthmus::Pore> Find(const std::vector<isthmus::Ball>& balls, const PoreQuery& ways,
  const isthmus::PoreOptions& options, const isthmus::ProgressCallback& progress)
{
  const auto point = [](const double* p) { return isthmus::Point3{ p[0], p[1], p[2] }; };
  if (ways.Mode == vtkPoreProfile::Automatic || balls.empty())
  {
    return isthmus::FindPores(balls, options, progress);
  }
  if (ways.Mode == vtkPoreProfile::TwoPoints)
  {
    return { isthmus::PoreBetween(
      balls, point(ways.Point1), point(ways.Point2), options, progress) };
  }
  return { isthmus::PoreAlong(balls, point(ways.Point), point(ways.Direction), options, progress) };
}

/// Notes where the balls of neighbouring planes do not meet.
void NoteJumps(const std::vector<isthmus::Pore>& pores, std::vector<std::string>& notes)
{
  for (std::size_t pore = 0; pore < pores.size(); ++pore)
  {
    const auto& samples = pores[pore].Samples;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    {
      const double jump = samples[i + 1].ArcLength - samples[i].ArcLength;
      if (jump > samples[i].Radius + samples[i + 1].Radius)
      {
        notes.push_back("Pore " + std::to_string(pore + 1) + " jumps by " +
          isthmus::FormatNumber(jump) + " at ArcLength " +
          isthmus::FormatNumber(samples[i].ArcLength) +
          ": of its radius in between only RadiusError is known.");
      }
    }
  }
}

/// Returns a warning about residues of low confidence at the first pore.
std::string Fill(
  const isthmus::PoreReport& report, vtkPointSet* input, vtkInformationVector* outputs)
{
  auto* lines = vtkPolyData::GetData(outputs, 0);
  isthmus::FillPoreLines(report, lines);
  isthmus::FillPoreSamples(report, vtkTable::GetData(outputs, 1));
  isthmus::FillPoreTable(report, vtkTable::GetData(outputs, 2));
  isthmus::FillBottlenecks(report, vtkPolyData::GetData(outputs, 3));
  const auto residues = isthmus::PoreLining(report);
  isthmus::FillPoreLining(report, residues, vtkTable::GetData(outputs, 4));
  isthmus::FillTubes(lines, vtkPolyData::GetData(outputs, 5));
  isthmus::FillPoreLiningAtoms(report, residues, input, vtkPolyData::GetData(outputs, 6));
  isthmus::AddNotes(report.Atoms.Notes, lines);
  return residues.empty()
    ? std::string()
    : isthmus::DescribeConfidence(residues.front(), report.Atoms, "the first pore");
}

}

const std::vector<isthmus::OutputArray>& vtkPoreProfile::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Radius", 1, "length", ArrayChoice::None, "of the largest ball" },
    { 0, ArrayPlace::Points, "RadiusError", 1, "length", ArrayChoice::None,
      "estimate: how far the radius between this plane and the next ones is from a line between "
      "their radii" },
    { 0, ArrayPlace::Points, "ArcLength", 1, "length", ArrayChoice::None, "along the pore" },
    { 0, ArrayPlace::Points, "NearestAtom", 1, "", ArrayChoice::None, "point of the input" },
    { 0, ArrayPlace::Points, "NearestResidue", 1, "", ArrayChoice::None, "chain, name and number" },
    { 0, ArrayPlace::Points, "WidthClass", 1, "", ArrayChoice::None,
      "0 too narrow for water (radius below 1.15), 1 room for one water molecule, 2 for two "
      "(from 2.30)" },
    { 0, ArrayPlace::Points, "PoreId", 1, "", ArrayChoice::None, "1 is the longest pore" },
    { 1, ArrayPlace::Rows, "Radius", 1, "length", ArrayChoice::None, "of the largest ball" },
    { 1, ArrayPlace::Rows, "RadiusError", 1, "length", ArrayChoice::None,
      "estimate: how far the radius between this plane and the next ones is from a line between "
      "their radii" },
    { 1, ArrayPlace::Rows, "ArcLength", 1, "length", ArrayChoice::None, "along the pore" },
    { 1, ArrayPlace::Rows, "NearestAtom", 1, "", ArrayChoice::None, "point of the input" },
    { 1, ArrayPlace::Rows, "NearestResidue", 1, "", ArrayChoice::None, "chain, name and number" },
    { 1, ArrayPlace::Rows, "WidthClass", 1, "", ArrayChoice::None,
      "0 too narrow for water (radius below 1.15), 1 room for one water molecule, 2 for two "
      "(from 2.30)" },
    { 1, ArrayPlace::Rows, "PoreId", 1, "", ArrayChoice::None, "1 is the longest pore" },
    { 0, ArrayPlace::Cells, "PoreId", 1, "", ArrayChoice::None, "1 is the longest pore" },
    { 1, ArrayPlace::Rows, "X", 1, "length", ArrayChoice::None, "center of the ball" },
    { 1, ArrayPlace::Rows, "Y", 1, "length", ArrayChoice::None, "center of the ball" },
    { 1, ArrayPlace::Rows, "Z", 1, "length", ArrayChoice::None, "center of the ball" },
    { 2, ArrayPlace::Rows, "PoreId", 1, "", ArrayChoice::None, "1 is the longest pore" },
    { 2, ArrayPlace::Rows, "Direction", 1, "", ArrayChoice::None,
      "a, b or c: the vector of the cell along which a ball of Radius gets through the crystal; "
      "empty: other modes than CellVectors" },
    { 2, ArrayPlace::Rows, "Radius", 1, "length", ArrayChoice::None, "the smallest" },
    { 2, ArrayPlace::Rows, "RadiusError", 1, "length", ArrayChoice::None,
      "estimate: the radius between the planes is as small as Radius - RadiusError" },
    { 2, ArrayPlace::Rows, "Length", 1, "length", ArrayChoice::None, "of the pore" },
    { 2, ArrayPlace::Rows, "Span", 1, "length", ArrayChoice::None, "distance between its ends" },
    { 2, ArrayPlace::Rows, "Bottlenecks", 1, "", ArrayChoice::None, "their number" },
    { 2, ArrayPlace::Rows, "BottleneckX", 1, "length", ArrayChoice::None,
      "position of the narrowest place" },
    { 2, ArrayPlace::Rows, "BottleneckY", 1, "length", ArrayChoice::None,
      "position of the narrowest place" },
    { 2, ArrayPlace::Rows, "BottleneckZ", 1, "length", ArrayChoice::None,
      "position of the narrowest place" },
    { 2, ArrayPlace::Field, "LargestIncludedRadius", 1, "length", ArrayChoice::None,
      "of the largest ball between the atoms of a crystal; with CellVectors" },
    { 2, ArrayPlace::Field, "LargestIncludedCenter", 3, "length", ArrayChoice::None,
      "its center; with CellVectors" },
    { 3, ArrayPlace::Points, "PoreId", 1, "", ArrayChoice::None, "of the pore" },
    { 3, ArrayPlace::Points, "Rank", 1, "", ArrayChoice::None,
      "1 is the narrowest bottleneck of the pore" },
    { 3, ArrayPlace::Points, "Radius", 1, "length", ArrayChoice::None, "of the largest ball" },
    { 3, ArrayPlace::Points, "RadiusError", 1, "length", ArrayChoice::None,
      "estimate: the radius between the planes is as small as Radius - RadiusError" },
    { 3, ArrayPlace::Points, "ArcLength", 1, "length", ArrayChoice::None, "along the pore" },
    { 3, ArrayPlace::Points, "NearestAtom", 1, "", ArrayChoice::None, "point of the input" },
    { 3, ArrayPlace::Points, "NearestResidue", 1, "", ArrayChoice::None, "chain, name and number" },
    { 3, ArrayPlace::Points, "WidthClass", 1, "", ArrayChoice::None, "as on output 0" },
    { 3, ArrayPlace::Points, "Residues", 1, "", ArrayChoice::None,
      "those within 0.5 angstrom of touching the ball" },
    { 4, ArrayPlace::Rows, "PoreId", 1, "", ArrayChoice::None, "of the pore" },
    { 4, ArrayPlace::Rows, "Chain", 1, "", ArrayChoice::None, "of the residue" },
    { 4, ArrayPlace::Rows, "ResidueId", 1, "", ArrayChoice::None, "of the residue" },
    { 4, ArrayPlace::Rows, "InsertionCode", 1, "", ArrayChoice::None, "of the residue" },
    { 4, ArrayPlace::Rows, "ResidueName", 1, "", ArrayChoice::None, "of the residue" },
    { 4, ArrayPlace::Rows, "Atoms", 1, "", ArrayChoice::None, "names of the lining atoms" },
    { 4, ArrayPlace::Rows, "AtomIds", 1, "", ArrayChoice::None, "points of the input" },
    { 4, ArrayPlace::Rows, "NumberOfAtoms", 1, "", ArrayChoice::None, "lining atoms" },
    { 5, ArrayPlace::Points, "Radius", 1, "length", ArrayChoice::None,
      "of the nearest sample of the pore" },
    { 5, ArrayPlace::Points, "RadiusError", 1, "length", ArrayChoice::None,
      "estimate: how far the radius between this plane and the next ones is from a line between "
      "their radii" },
    { 5, ArrayPlace::Points, "ArcLength", 1, "length", ArrayChoice::None,
      "of the nearest sample of the pore" },
    { 5, ArrayPlace::Points, "NearestAtom", 1, "", ArrayChoice::None,
      "of the nearest sample of the pore" },
    { 5, ArrayPlace::Points, "NearestResidue", 1, "", ArrayChoice::None,
      "of the nearest sample of the pore" },
    { 5, ArrayPlace::Points, "WidthClass", 1, "", ArrayChoice::None,
      "of the nearest sample of the pore" },
    { 5, ArrayPlace::Points, "PoreId", 1, "", ArrayChoice::None,
      "of the nearest sample of the pore" },
    { 5, ArrayPlace::Points, "TubeNormals", 3, "", ArrayChoice::None, "unit" },
    { 5, ArrayPlace::Cells, "PoreId", 1, "", ArrayChoice::None, "of the pore" },
    { 6, ArrayPlace::Points, "PoreId", 1, "", ArrayChoice::None, "of the pore" },
    { 6, ArrayPlace::Points, "ResidueLabel", 1, "", ArrayChoice::None,
      "name and number of the residue, at one of its atoms" },
  };
  return table;
}

vtkPoreProfile::vtkPoreProfile()
{
  this->SetNumberOfOutputPorts(7);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
}

vtkTable* vtkPoreProfile::GetProfile()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

vtkTable* vtkPoreProfile::GetPoreTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

vtkPolyData* vtkPoreProfile::GetBottlenecks()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(3));
}

vtkTable* vtkPoreProfile::GetLiningResidues()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(4));
}

vtkPolyData* vtkPoreProfile::GetTubes()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(5));
}

vtkPolyData* vtkPoreProfile::GetLiningAtoms()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(6));
}

int vtkPoreProfile::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkPoreProfile::FillOutputPortInformation(int port, vtkInformation* info)
{
  const bool isTable = port == 1 || port == 2 || port == 4;
  info->Set(vtkDataObject::DATA_TYPE_NAME(), isTable ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkPoreProfile::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0], 0);
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      isthmus::RequireOneRank(this, input, "atoms");
      if (input)
      {
        this->Compute(input, outputVector);
      }
      isthmus::Report(isthmus::MakeProgress(this), 1.0);
    });
}

namespace
{

void TakeRadiiOfHole(const std::vector<int>& elements, isthmus::MoleculeAtoms& atoms)
{
  for (std::size_t i = 0; i < atoms.Balls.size(); ++i)
  {
    const double radius = isthmus::VanDerWaalsRadius(
      elements[static_cast<std::size_t>(atoms.Points[i])], isthmus::RadiusTable::UnitedAtom);
    atoms.Balls[i].Radius = std::isnan(radius) ? atoms.Balls[i].Radius : radius;
  }
}

/// The pores along the vectors of the cell. `atoms` become those around the pores, with copies.
std::vector<isthmus::Pore> FindInCrystal(vtkPointSet* input, const isthmus::PoreOptions& options,
  isthmus::MoleculeAtoms& atoms, vtkTable* table, const isthmus::ProgressCallback& progress)
{
  const isthmus::PeriodicCell cell = isthmus::ReadPeriodicCell(input, atoms.Warnings);
  isthmus::PeriodicPores found = isthmus::FindPeriodicPores(atoms.Balls, cell, options, progress);
  std::vector<vtkIdType> points;
  for (const std::size_t atom : found.Atoms)
  {
    points.push_back(atoms.Points[atom]);
  }
  atoms.Balls = std::move(found.Images);
  atoms.Points = std::move(points);
  isthmus::AddColumn<vtkDoubleArray>(
    table->GetFieldData(), "LargestIncludedRadius", { found.LargestRadius });
  isthmus::AddTuple<vtkDoubleArray>(
    table->GetFieldData(), "LargestIncludedCenter", found.LargestCenter);
  for (const char* direction : { "a", "b", "c" })
  {
    if (std::none_of(found.Pores.begin(), found.Pores.end(),
          [&](const isthmus::Pore& pore) { return pore.Direction == direction; }))
    {
      atoms.Notes.push_back(std::string("Atoms block all ways along ") + direction + ".");
    }
  }
  return std::move(found.Pores);
}

}

void vtkPoreProfile::Compute(vtkPointSet* input, vtkInformationVector* outputs)
{
  isthmus::Check(this->Parameters);
  isthmus::RequireRange("Mode", this->Mode, Automatic, CellVectors);
  isthmus::RequireRange("RadiusTable", this->RadiusTable, OfInput, Hole);
  isthmus::PolymerOptions keep;
  keep.Hydrogens = this->IncludeHydrogens;
  keep.Ions = this->IncludeIons;
  keep.Ligands = this->IncludeLigands;
  keep.ProstheticGroups = true;
  isthmus::AtomOptions which = isthmus::SelectPolymer(isthmus::InputArrayName(this, 0), keep);
  which.SurfacePoints = true;
  which.MinimumConfidence = this->MinimumConfidence;
  isthmus::MoleculeAtoms atoms = isthmus::ReadAtoms(input, which);
  if (this->RadiusTable == Hole && atoms.HasElements)
  {
    TakeRadiiOfHole(isthmus::AtomElements(input), atoms);
  }
  isthmus::PoreOptions options = this->Parameters;
  options.Predicted = isthmus::WarnAboutLongTriangulation(this);
  if (atoms.IsSurface)
  {
    const double longest = LongestEdge(vtkPolyData::SafeDownCast(input));
    if (longest > options.MinimumRadius)
    {
      options.MinimumRadius = longest;
      atoms.Notes.push_back("The surface's points are up to " + isthmus::FormatNumber(longest) +
        " apart: channels narrower than that are not found.");
    }
  }
  const auto progress = isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.95);
  const PoreQuery ways{ this->Mode, this->Point1, this->Point2, this->Point, this->Direction };
  const auto pores = this->Mode == CellVectors
    ? FindInCrystal(input, options, atoms, vtkTable::GetData(outputs, 2), progress)
    : Find(atoms.Balls, ways, options, progress);
  NoteJumps(pores, atoms.Notes);
  const std::string confidence = Fill({ pores, atoms }, input, outputs);
  if (!confidence.empty())
  {
    atoms.Warnings.push_back(confidence);
  }
  for (const std::string& warning : atoms.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
}

void vtkPoreProfile::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  os << indent << "Mode: " << this->Mode << "\n";
  vector("Point1", this->Point1);
  vector("Point2", this->Point2);
  vector("Point", this->Point);
  vector("Direction", this->Direction);
  os << indent << "RadiusTable: " << this->RadiusTable << "\n";
  os << indent << "EndRadius: " << this->GetEndRadius() << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "MinimumRadius: " << this->GetMinimumRadius() << "\n";
  os << indent << "MinimumSpan: " << this->GetMinimumSpan() << "\n";
  os << indent << "MaximumPores: " << this->GetMaximumPores() << "\n";
  os << indent << "MaximumOffset: " << this->GetMaximumOffset() << "\n";
  os << indent << "IncludeHydrogens: " << this->IncludeHydrogens << "\n";
  os << indent << "IncludeIons: " << this->IncludeIons << "\n";
  os << indent << "IncludeLigands: " << this->IncludeLigands << "\n";
  os << indent << "MinimumConfidence: " << this->MinimumConfidence << "\n";
}
