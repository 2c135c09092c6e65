#include "Pockets/PocketOutput.h"

#include "Core/ArrayMemory.h"
#include "Core/NamedColumns.h"
#include "Core/PolyDataTriangles.h"
#include "Pockets/LiningResidues.h"
#include "Pockets/SiteDescriptors.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <limits>
#include <map>

namespace isthmus
{
namespace
{

/// Points of atoms, each once for each pocket.
class AtomPointInserter
{
public:
  AtomPointInserter(const MoleculeAtoms& atoms, vtkPoints* points, vtkIdTypeArray* ids)
    : Atoms(atoms)
    , Points(points)
    , Ids(ids)
  {
    points->SetDataTypeToDouble();
  }

  void NextPocket() { this->Places.clear(); }

  vtkIdType operator()(std::int64_t atom)
  {
    const auto [at, isNew] = this->Places.emplace(atom, this->Points->GetNumberOfPoints());
    if (isNew)
    {
      const auto i = static_cast<std::size_t>(atom);
      this->Points->InsertNextPoint(this->Atoms.Balls[i].Center.data());
      this->Ids->InsertNextValue(this->Atoms.Points[i]);
    }
    return at->second;
  }

private:
  const MoleculeAtoms& Atoms;
  vtkPoints* Points;
  vtkIdTypeArray* Ids;
  std::map<std::int64_t, vtkIdType> Places;
};

int GetPocketId(std::size_t pocket)
{
  return static_cast<int>(pocket) + 1;
}

/// Shares of the lining surface on nitrogen and oxygen, and on the rest; NaN without elements.
std::array<double, 2> PolarShares(const Pocket& pocket, const MoleculeAtoms& atoms)
{
  double polar = 0.0;
  double all = 0.0;
  for (const LiningAtom& lining : pocket.Lining)
  {
    const auto point =
      static_cast<std::size_t>(atoms.Points[static_cast<std::size_t>(lining.Atom)]);
    const int element = atoms.Named[point].Element;
    polar += element == 7 || element == 8 ? lining.Area : 0.0;
    all += lining.Area;
  }
  if (!atoms.HasElements || all <= 0.0)
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    return { unknown, unknown };
  }
  return { polar / all, 1.0 - polar / all };
}

}

namespace
{

/// Of all pockets.
vtkIdType NumberOfCells(const PocketReport& report)
{
  vtkIdType count = 0;
  for (const auto& pocket : report.Pockets)
  {
    count += static_cast<vtkIdType>(pocket.Cells.size());
  }
  return count;
}

/// The descriptors of the places, for training, if they were kept.
vtkSmartPointer<vtkFloatArray> MakeDescriptorArray(const std::vector<SitePlace>& places)
{
  std::vector<std::string> names = SiteDescriptorNames();
  for (const std::string& residue : SiteResidueNames())
  {
    names.push_back("Near " + residue);
  }
  auto array = NamedArray<vtkFloatArray>("SiteDescriptors", 0, static_cast<int>(names.size()));
  for (std::size_t k = 0; k < names.size(); ++k)
  {
    array->SetComponentName(static_cast<vtkIdType>(k), names[k].c_str());
  }
  for (const SitePlace& place : places)
  {
    array->InsertNextTypedTuple(place.Descriptors.data());
  }
  return array;
}

}

void FillPocketCells(const PocketReport& report, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  auto ids = NamedArray<vtkIdTypeArray>("AtomId");
  auto pocketId = NamedArray<vtkIntArray>("PocketId");
  auto clearance = NamedArray<vtkDoubleArray>("Clearance");
  auto access = NamedArray<vtkDoubleArray>("AccessRadius");
  auto burial = NamedArray<vtkIdTypeArray>("Burial");
  auto volume = NamedArray<vtkDoubleArray>("EmptyVolume");
  auto probability = NamedArray<vtkDoubleArray>("SiteProbability");
  AtomPointInserter place(report.Atoms, points, ids);
  const vtkIdType count = NumberOfCells(report);
  vtkNew<vtkCellArray> cells;
  ReserveCells(cells, count, 4 * count);
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{
         pocketId, clearance, access, burial, volume, probability })
  {
    ReserveArray(array, count);
  }
  for (std::size_t i = 0; i < report.Pockets.size(); ++i)
  {
    place.NextPocket();
    for (const PocketCell& cell : report.Pockets[i].Cells)
    {
      vtkIdType corners[4];
      std::transform(cell.Atoms.begin(), cell.Atoms.end(), corners, std::ref(place));
      double p[4][3];
      for (int k = 0; k < 4; ++k)
      {
        points->GetPoint(corners[k], p[k]);
      }
      const Point3 origin{ p[0][0], p[0][1], p[0][2] };
      const auto side = [&](int k) { return Point3{ p[k][0], p[k][1], p[k][2] } - origin; };
      if (Dot(side(3), Cross(side(1), side(2))) < 0.0)
      {
        std::swap(corners[2], corners[3]);
      }
      cells->InsertNextCell(4, corners);
      pocketId->InsertNextValue(GetPocketId(i));
      clearance->InsertNextValue(cell.Clearance);
      access->InsertNextValue(cell.Access);
      burial->InsertNextValue(cell.Burial);
      volume->InsertNextValue(cell.Volume);
      probability->InsertNextValue(cell.SiteProbability);
    }
  }
  output->SetPoints(points);
  SetCellsOfType(output, VTK_TETRA, cells);
  output->GetPointData()->AddArray(ids);
  output->GetCellData()->SetScalars(pocketId);
  for (vtkDataArray* array :
    std::initializer_list<vtkDataArray*>{ clearance, access, burial, volume, probability })
  {
    output->GetCellData()->AddArray(array);
  }
}

void FillPocketTable(const PocketReport& report, vtkTable* output)
{
  vtkFieldData* const data = output->GetRowData();
  const auto add = [&](const char* name, const auto& value)
  {
    AddComputedColumn<vtkDoubleArray>(data, name, report.Pockets.size(),
      [&](std::size_t i) { return value(report.Pockets[i], i); });
  };
  const auto addCount = [&](const char* name, const auto& value)
  { AddComputedColumn<vtkIntArray>(data, name, report.Pockets, value); };
  AddComputedColumn<vtkIntArray>(data, "Rank", report.Pockets.size(), GetPocketId);
  using P = const Pocket&;
  add("Probability", [](P p, std::size_t) { return p.Probability; });
  add("Score", [](P p, std::size_t) { return p.Score; });
  add("CenterX", [](P p, std::size_t) { return p.Center[0]; });
  add("CenterY", [](P p, std::size_t) { return p.Center[1]; });
  add("CenterZ", [](P p, std::size_t) { return p.Center[2]; });
  add("Volume", [](P p, std::size_t) { return p.Volume; });
  add("Area", [](P p, std::size_t) { return p.Area; });
  addCount("Mouths", [](P p) { return p.Mouths.size(); });
  add("MouthRadius",
    [](P p, std::size_t) { return p.Mouths.empty() ? 0.0 : p.Mouths.front().Radius; });
  add("MouthArea",
    [](P p, std::size_t)
    {
      double area = 0.0;
      for (const PocketMouth& mouth : p.Mouths)
      {
        area += mouth.Area;
      }
      return area;
    });
  add("Radius", [](P p, std::size_t) { return p.Radius; });
  add("PolarShare", [&](P p, std::size_t) { return PolarShares(p, report.Atoms)[0]; });
  add("ApolarShare", [&](P p, std::size_t) { return PolarShares(p, report.Atoms)[1]; });
  addCount("LiningAtoms", [](P p) { return p.Lining.size(); });
  addCount("Cells", [](P p) { return p.Cells.size(); });
  addCount("Parent", [](P p) { return p.Parent; });
  std::map<std::int64_t, int> first; // rank of the first site of each group of copies
  for (std::size_t i = 0; i < report.Pockets.size(); ++i)
  {
    first.emplace(report.Pockets[i].Group, GetPocketId(i));
  }
  addCount("CopyOf", [&](P p) { return std::isnan(p.Probability) ? 0 : first[p.Group]; });
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto mean = [&](std::size_t i, double PocketSurfaceMeans::*member)
  { return report.Means.empty() ? unknown : report.Means[i].*member; };
  add("MeanPotential", [&](P, std::size_t i) { return mean(i, &PocketSurfaceMeans::Potential); });
  add("MeanPolarized", [&](P, std::size_t i) { return mean(i, &PocketSurfaceMeans::Polarized); });
  AddComputedColumn<vtkStringArray>(data, "Residues", report.Pockets,
    [&](P p) { return JoinNames(FindLiningResidues(p.Lining, report.Atoms), report.Atoms); });
}

void FillMouths(const PocketReport& report, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  auto ids = NamedArray<vtkIdTypeArray>("AtomId");
  auto pocketId = NamedArray<vtkIntArray>("PocketId");
  auto mouthId = NamedArray<vtkIntArray>("MouthId");
  auto clearance = NamedArray<vtkDoubleArray>("Clearance");
  AtomPointInserter place(report.Atoms, points, ids);
  for (std::size_t i = 0; i < report.Pockets.size(); ++i)
  {
    place.NextPocket();
    const auto& mouths = report.Pockets[i].Mouths;
    for (std::size_t m = 0; m < mouths.size(); ++m)
    {
      for (std::size_t t = 0; t < mouths[m].Triangles.size(); ++t)
      {
        const auto& atoms = mouths[m].Triangles[t];
        const vtkIdType corners[3] = { place(atoms[0]), place(atoms[1]), place(atoms[2]) };
        triangles->InsertNextCell(3, corners);
        pocketId->InsertNextValue(GetPocketId(i));
        mouthId->InsertNextValue(GetPocketId(m));
        clearance->InsertNextValue(mouths[m].Clearance[t]);
      }
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  output->GetPointData()->AddArray(ids);
  output->GetCellData()->SetScalars(pocketId);
  output->GetCellData()->AddArray(mouthId);
  output->GetCellData()->AddArray(clearance);
}

void FillAlphaBalls(const PocketReport& report, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  auto pocketId = NamedArray<vtkIntArray>("PocketId");
  auto radius = NamedArray<vtkDoubleArray>("Radius");
  auto access = NamedArray<vtkDoubleArray>("AccessRadius");
  auto burial = NamedArray<vtkIdTypeArray>("Burial");
  const vtkIdType count = NumberOfCells(report);
  ReserveCells(vertices, count, count);
  for (vtkDataArray* array :
    std::initializer_list<vtkDataArray*>{ points->GetData(), pocketId, radius, access, burial })
  {
    ReserveArray(array, count);
  }
  for (std::size_t i = 0; i < report.Pockets.size(); ++i)
  {
    for (const PocketCell& cell : report.Pockets[i].Cells)
    {
      const vtkIdType id = points->InsertNextPoint(cell.Center.data());
      vertices->InsertNextCell(1, &id);
      pocketId->InsertNextValue(GetPocketId(i));
      radius->InsertNextValue(cell.Clearance);
      access->InsertNextValue(cell.Access);
      burial->InsertNextValue(cell.Burial);
    }
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->SetScalars(pocketId);
  output->GetPointData()->AddArray(radius);
  output->GetPointData()->AddArray(access);
  output->GetPointData()->AddArray(burial);
}

void FillLiningResidues(const PocketReport& report, vtkTable* output)
{
  LiningTable table("PocketId");
  for (std::size_t i = 0; i < report.Pockets.size(); ++i)
  {
    table.Add(
      GetPocketId(i), FindLiningResidues(report.Pockets[i].Lining, report.Atoms), report.Atoms);
  }
  table.Fill(output);
}

void FillSiteSurface(const PocketReport& report, const std::vector<SitePlace>& places,
  vtkPolyData* surface, vtkPolyData* output)
{
  if (!surface)
  {
    auto probability = NamedArray<vtkDoubleArray>("SiteProbability");
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> vertices;
    for (const SitePlace& place : places)
    {
      const vtkIdType id = points->InsertNextPoint(place.Center.data());
      vertices->InsertNextCell(1, &id);
      probability->InsertNextValue(place.Probability);
    }
    output->SetPoints(points);
    output->SetVerts(vertices);
    output->GetPointData()->SetScalars(probability);
    if (!places.empty() && !places.front().Descriptors.empty())
    {
      output->GetPointData()->AddArray(MakeDescriptorArray(places));
    }
    return;
  }
  output->ShallowCopy(surface);
  const PolyDataTriangles triangles(surface);
  AddColumn<vtkIntArray>(
    output->GetPointData(), "PocketId", LabelPocketSurfaces(triangles.View(), report.Pockets));
  AddColumn<vtkDoubleArray>(
    output->GetPointData(), "SiteProbability", SiteProbabilities(triangles.View(), places));
  output->GetPointData()->SetActiveScalars("SiteProbability");
}

void FillLiningAtoms(const PocketReport& report, vtkPointSet* input, int shown, vtkPolyData* output)
{
  ResidueAtoms atoms(report.Atoms, input, "PocketId");
  for (std::size_t i = 0; i < report.Pockets.size(); ++i)
  {
    if (shown == 0 || shown == GetPocketId(i))
    {
      atoms.Add(GetPocketId(i), FindLiningResidues(report.Pockets[i].Lining, report.Atoms));
    }
  }
  atoms.Fill(output);
}

}
