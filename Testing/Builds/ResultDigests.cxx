// Prints a digest of what filters and readers make of the shared data, a line each: two builds of
// the same sources, with other versions of VTK or on other machines, are compared by `diff`.
//
//     [ISTHMUS_DATA_DIR=FOLDER] ResultDigests
//
// A digest is 64-bit FNV-1a over points, cells and all arrays: names, shapes, and each value as the
// bits of a double. Nothing of VTK's own memory layout goes in, since that differs between
// versions. Ends with 1 where a result is empty.

#include "SharedData.h"
#include "vtkCellIncidence.h"
#include "vtkChokingLoops.h"
#include "vtkDualContouring.h"
#include "vtkHessianCurvature.h"
#include "vtkHighOrderDiffusion.h"
#include "vtkIsosurfaceStuffing.h"
#include "vtkMEDITReader.h"
#include "vtkMRCMapReader.h"
#include "vtkMacromoleculeReader.h"
#include "vtkMapSurface.h"
#include "vtkMeshQualityReport.h"
#include "vtkMolecularDensity.h"
#include "vtkMolecularFlowSurface.h"
#include "vtkMolecularPockets.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkPoissonBoltzmann.h"
#include "vtkScalarPersistence.h"
#include "vtkSurfaceCurvature.h"
#include "vtkSurfaceToGrid.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <array>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>

namespace
{

class Digest
{
public:
  void Add(double value)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    this->AddBytes(bits, 8);
  }

  void Add(const std::string& text)
  {
    this->Add(static_cast<double>(text.size()));
    for (const char c : text)
    {
      this->AddBytes(static_cast<unsigned char>(c), 1);
    }
  }

  void Add(vtkFieldData* data)
  {
    for (int i = 0; data && i < data->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* const array = data->GetAbstractArray(i);
      const std::string name = array->GetName() ? array->GetName() : "";
      this->Add(name);
      this->Add(static_cast<double>(array->GetNumberOfComponents()));
      this->Add(static_cast<double>(array->GetNumberOfTuples()));
      this->AddValues(array);
    }
  }

  void Add(vtkDataObject* object)
  {
    this->Add(object->GetFieldData());
    if (auto* table = vtkTable::SafeDownCast(object))
    {
      this->Values += table->GetNumberOfRows();
      this->Add(table->GetRowData());
    }
    else if (auto* set = vtkDataSet::SafeDownCast(object))
    {
      this->AddGeometry(set);
      this->Add(set->GetPointData());
      this->Add(set->GetCellData());
    }
  }

  std::uint64_t Value() const { return this->State; }
  /// Points and rows seen.
  vtkIdType Size() const { return this->Values; }

private:
  void AddBytes(std::uint64_t bytes, int count)
  {
    for (int i = 0; i < count; ++i, bytes >>= 8)
    {
      this->State = (this->State ^ (bytes & 0xff)) * 1099511628211ULL;
    }
  }

  void AddValues(vtkAbstractArray* array)
  {
    auto* numbers = vtkDataArray::SafeDownCast(array);
    auto* words = vtkStringArray::SafeDownCast(array);
    for (vtkIdType t = 0; numbers && t < numbers->GetNumberOfTuples(); ++t)
    {
      for (int c = 0; c < numbers->GetNumberOfComponents(); ++c)
      {
        this->Add(numbers->GetComponent(t, c));
      }
    }
    for (vtkIdType i = 0; words && i < words->GetNumberOfValues(); ++i)
    {
      this->Add(std::string(words->GetValue(i)));
    }
  }

  void AddGeometry(vtkDataSet* set)
  {
    this->Values += set->GetNumberOfPoints();
    double place[3];
    for (vtkIdType i = 0; i < set->GetNumberOfPoints(); ++i)
    {
      set->GetPoint(i, place);
      for (const double coordinate : place)
      {
        this->Add(coordinate);
      }
    }
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < set->GetNumberOfCells(); ++i)
    {
      set->GetCellPoints(i, corners);
      this->Add(static_cast<double>(set->GetCellType(i)));
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      {
        this->Add(static_cast<double>(corners->GetId(k)));
      }
    }
  }

  std::uint64_t State = 14695981039346656037ULL;
  vtkIdType Values = 0;
};

bool AllTold = true;

/// Runs `algorithm` and tells what all its outputs hold.
void Tell(const char* what, vtkAlgorithm* algorithm)
{
  algorithm->Update();
  Digest digest;
  for (int port = 0; port < algorithm->GetNumberOfOutputPorts(); ++port)
  {
    digest.Add(algorithm->GetOutputDataObject(port));
  }
  std::printf("%016" PRIx64 "  %9lld points and rows  %s\n", digest.Value(),
    static_cast<long long>(digest.Size()), what);
  std::fflush(stdout);
  AllTold = AllTold && digest.Size() > 0;
}

/// Runs a filter on the first output of `source`.
template <typename Filter>
vtkNew<Filter> TellOf(const char* what, vtkAlgorithm* source, void (*set)(Filter*) = nullptr)
{
  vtkNew<Filter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  if (set)
  {
    set(filter);
  }
  Tell(what, filter);
  return filter;
}

void TellOfMap(const std::string& path)
{
  vtkNew<vtkMRCMapReader> map;
  map->SetFileName(path.c_str());
  Tell("EMD-1832: map", map);
  TellOf<vtkHighOrderDiffusion>("EMD-1832: high-order diffusion", map);
  TellOf<vtkHessianCurvature>(
    "EMD-1832: curvature", map, [](vtkHessianCurvature* filter) { filter->AutomaticScaleOff(); });
  TellOf<vtkHessianCurvature>("EMD-1832: curvature, automatic scale", map);
  TellOf<vtkMapSurface>("EMD-1832: surface", map);
  TellOf<vtkScalarPersistence>("EMD-1832: persistence", map);
}

void TellOfSurface(const std::string& path)
{
  vtkNew<vtkOFFSurfaceReader> surface;
  surface->SetFileName(path.c_str());
  Tell("3holes: surface", surface);
  TellOf<vtkSurfaceCurvature>("3holes: curvature", surface);
  TellOf<vtkChokingLoops>("3holes: choking loops", surface);
  const auto grid = TellOf<vtkSurfaceToGrid>("3holes: distance", surface);
  const auto outside = [](auto* filter)
  {
    filter->SetLevel(0.0);
    filter->SetInsideIsHigher(false);
  };
  TellOf<vtkDualContouring>("3holes: dual contouring", grid, outside);
  const auto cells = TellOf<vtkIsosurfaceStuffing>("3holes: isosurface stuffing", grid, outside);
  TellOf<vtkMeshQualityReport>("3holes: quality", cells);
}

void TellOfMolecule(const std::string& path)
{
  vtkNew<vtkMacromoleculeReader> atoms;
  atoms->SetFileName(path.c_str());
  Tell("1CRN: atoms", atoms);
  TellOf<vtkMolecularDensity>("1CRN: density", atoms);
  TellOf<vtkMolecularFlowSurface>("1CRN: flow surface", atoms);
  TellOf<vtkPoissonBoltzmann>(
    "1CRN: potential", atoms, [](vtkPoissonBoltzmann* solver) { solver->SetSpacing(1.0); });
}

void TellOfPockets(const std::string& path)
{
  vtkNew<vtkMacromoleculeReader> atoms;
  atoms->SetFileName(path.c_str());
  Tell("1HEW: atoms", atoms);
  TellOf<vtkMolecularPockets>("1HEW: pockets", atoms);
}

void TellOfCells(const std::string& path)
{
  vtkNew<vtkMEDITReader> cells;
  cells->SetFileName(path.c_str());
  Tell("Octopus: tetrahedra", cells);
  TellOf<vtkCellIncidence>("Octopus: incidences", cells);
}

}

int main()
{
  const std::filesystem::path data = isthmus::testing::SharedDataFolder();
  const std::array<std::pair<void (*)(const std::string&), const char*>, 5> parts{ {
    { TellOfMap, "maps/emd_1832.map" },
    { TellOfSurface, "surfaces/3holes.off" },
    { TellOfMolecule, "molecules/1crn_apbs.pqr" },
    { TellOfPockets, "molecules/1hew.pdb" },
    { TellOfCells, "volumes/octopus-low.mesh" },
  } };
  for (const auto& [tell, file] : parts)
  {
    if (!std::filesystem::exists(data / file))
    {
      std::fprintf(stderr, "There is no %s: set ISTHMUS_DATA_DIR.\n", (data / file).c_str());
      return isthmus::testing::SharedDataRequired() ? 1 : 77;
    }
    tell((data / file).string());
  }
  return AllTold ? 0 : 1;
}
