#include "vtkCombinatorialMap.h"

#include "CellComplex/EdgeTable.h"
#include "CellComplex/FaceTable.h"
#include "CellComplex/GridMap.h"
#include "CellComplex/StarWalk.h"
#include "Core/Index.h"

#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkObjectFactory.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkCombinatorialMap);

namespace
{

constexpr std::array<const char*, 6> KindNames = { "vertex", "edge", "face", "cell", "half face",
  "dart" };

void RequireKind(int kind)
{
  if (kind < 0 || kind >= static_cast<int>(KindNames.size()))
  {
    throw std::invalid_argument("There is no kind " + std::to_string(kind) +
      ": 0 vertex, 1 edge, 2 face, 3 cell, 4 half face, 5 dart.");
  }
}

}

/// A map with either width of ids.
class vtkCombinatorialMap::vtkInternals
{
public:
  virtual ~vtkInternals() = default;
  virtual vtkIdType Number(int kind) const = 0;
  virtual void Find(int from, vtkIdType id, int to, std::vector<vtkIdType>& found) = 0;
  virtual vtkIdType Beta(int dimension, vtkIdType dart) const = 0;
  virtual std::vector<isthmus::TableMemory> Tables() const = 0;
  virtual double Estimate() const = 0;

  vtkIdType CheckId(int kind, vtkIdType id) const
  {
    if (id < 0 || id >= this->Number(kind))
    {
      throw std::invalid_argument("There is no " + std::string(KindNames[isthmus::At(kind)]) + " " +
        std::to_string(id) + ": the mesh has " + std::to_string(this->Number(kind)) +
        " of them, from 0.");
    }
    return id;
  }
};

template <typename Map>
class vtkCombinatorialMap::vtkTypedInternals : public vtkCombinatorialMap::vtkInternals
{
public:
  vtkTypedInternals(vtkUnstructuredGrid* grid, const isthmus::GridCells& cells)
    : Mesh(cells.List())
    , Star(this->Mesh)
    , CellOfGrid(isthmus::At(grid->GetNumberOfCells()), -1)
  {
    this->GridCell.resize(this->Mesh.NumberOfCells());
    for (std::size_t c = 0; c < this->GridCell.size(); ++c)
    {
      this->GridCell[c] = cells.GridId(c);
      this->CellOfGrid[isthmus::At(this->GridCell[c])] = static_cast<vtkIdType>(c);
    }
  }

  vtkIdType Number(int kind) const override
  {
    switch (kind)
    {
      case Vertex:
        return static_cast<vtkIdType>(this->Mesh.NumberOfVertices());
      case Edge:
        return static_cast<vtkIdType>(this->Mesh.Edges().Size());
      case Face:
        return static_cast<vtkIdType>(this->Mesh.NumberOfFaces());
      case Cell:
        return static_cast<vtkIdType>(this->CellOfGrid.size());
      case HalfFace:
        return static_cast<vtkIdType>(this->Mesh.NumberOfHalfFaces());
      default:
        return static_cast<vtkIdType>(this->Mesh.NumberOfDarts());
    }
  }

  void Find(int from, vtkIdType id, int to, std::vector<vtkIdType>& found) override;

  vtkIdType Beta(int dimension, vtkIdType dart) const override
  {
    const DartId d = this->DartAt(dart);
    const DartId other = dimension == 1 ? this->Mesh.Beta1(d)
      : dimension == 2                  ? this->Mesh.Beta2(d)
                                        : this->Mesh.Beta3(d);
    return this->Mesh.IsOutside(other) ? -1 : static_cast<vtkIdType>(this->Mesh.GetIndex(other));
  }

  std::vector<isthmus::TableMemory> Tables() const override { return this->Mesh.MemoryReport(); }
  double Estimate() const override
  {
    return Map::EstimatedBytes(static_cast<double>(this->Mesh.NumberOfCells()),
      static_cast<double>(this->Mesh.NumberOfBoundaryFaces()));
  }

private:
  using Number_ = typename Map::IdType;
  using CellId = typename Map::Cell;
  using DartId = typename Map::Dart;
  using HalfFaceId = typename Map::HalfFace;

  /// The last cell whose elements, counted from `first(cell)`, begin at or before `id`.
  template <typename First>
  CellId CellAt(vtkIdType id, First&& first) const
  {
    std::size_t low = 0, high = this->Mesh.NumberOfCells();
    while (high - low > 1)
    {
      const std::size_t middle = (low + high) / 2;
      (first(CellId(static_cast<Number_>(middle))) <= isthmus::At(id) ? low : high) = middle;
    }
    return CellId(static_cast<Number_>(low));
  }
  DartId DartAt(vtkIdType id) const
  {
    const auto first = [this](CellId cell)
    { return this->Mesh.GetIndex(this->Mesh.MakeDart(cell, 1)); };
    const CellId cell = this->CellAt(id, first);
    return this->Mesh.MakeDart(cell, static_cast<unsigned>(isthmus::At(id) - first(cell) + 1));
  }
  HalfFaceId HalfFaceAt(vtkIdType id) const
  {
    const auto first = [this](CellId cell)
    { return this->Mesh.GetIndex(this->Mesh.MakeHalfFace(cell, 0)); };
    const CellId cell = this->CellAt(id, first);
    return this->Mesh.MakeHalfFace(cell, static_cast<unsigned>(isthmus::At(id) - first(cell)));
  }

  /// The element of kind `to` that a dart belongs to.
  vtkIdType Find(DartId dart, int to) const
  {
    switch (to)
    {
      case Vertex:
        return static_cast<vtkIdType>(this->Mesh.StartVertex(dart).Value);
      case Edge:
        return static_cast<vtkIdType>(this->Mesh.Edges().Find(dart).Value);
      case Face:
        return static_cast<vtkIdType>(this->Mesh.Faces().Find(dart).Value);
      case Cell:
        return this->GridCell[this->Mesh.GetCell(dart).Value];
      case HalfFace:
        return static_cast<vtkIdType>(this->Mesh.GetIndex(this->Mesh.GetHalfFace(dart)));
      default:
        return static_cast<vtkIdType>(this->Mesh.GetIndex(dart));
    }
  }

  template <typename Visit>
  void ForEachDart(int from, vtkIdType id, Visit&& visit);

  Map Mesh;
  isthmus::StarWalk<Number_> Star;
  std::vector<vtkIdType> GridCell;   ///< id in the grid
  std::vector<vtkIdType> CellOfGrid; ///< the inverse; -1: not a volume cell
};

/// Visits all darts of an element.
template <typename Map>
template <typename Visit>
void vtkCombinatorialMap::vtkTypedInternals<Map>::ForEachDart(int from, vtkIdType id, Visit&& visit)
{
  const auto visitHalf = [&](HalfFaceId half)
  {
    for (const DartId dart : this->Mesh.Darts(half))
    {
      visit(dart);
    }
  };
  switch (from)
  {
    case Vertex:
      this->Star.Gather(typename Map::Vertex(static_cast<Number_>(id)));
      for (const DartId dart : this->Star.Darts())
      {
        visit(dart);
      }
      break;
    case Edge:
      for (const DartId dart : this->Mesh.Edges().Fan(typename Map::Edge(static_cast<Number_>(id))))
      {
        visit(dart);
        visit(this->Mesh.Beta2(dart));
      }
      break;
    case Face:
    {
      const HalfFaceId half =
        this->Mesh.Faces().GetHalfFace(typename Map::Face(static_cast<Number_>(id)));
      visitHalf(half);
      if (!this->Mesh.IsBoundary(half))
      {
        visitHalf(this->Mesh.GetHalfFace(this->Mesh.Across(half)));
      }
      break;
    }
    case Cell:
      if (const vtkIdType cell = this->CellOfGrid[isthmus::At(id)]; cell >= 0)
      {
        for (const DartId dart : this->Mesh.Darts(CellId(static_cast<Number_>(cell))))
        {
          visit(dart);
        }
      }
      break;
    case HalfFace:
      visitHalf(this->HalfFaceAt(id));
      break;
    default:
      visit(this->DartAt(id));
  }
}

template <typename Map>
void vtkCombinatorialMap::vtkTypedInternals<Map>::Find(
  int from, vtkIdType id, int to, std::vector<vtkIdType>& found)
{
  found.clear();
  const auto add = [&found](vtkIdType element)
  {
    if (std::find(found.begin(), found.end(), element) == found.end())
    {
      found.push_back(element);
    }
  };
  if (from == to)
  {
    if (from != Vertex && from != Cell && from != HalfFace)
    {
      throw std::invalid_argument(
        std::string(
          "Only vertices, cells and half faces have neighbours of their own kind; request "
          "what is incident to the ") +
        KindNames[isthmus::At(from)] + " in another kind.");
    }
    this->ForEachDart(from, id,
      [&](DartId dart)
      {
        const DartId across = this->Mesh.Beta3(dart);
        if (from == Vertex)
        {
          add(static_cast<vtkIdType>(this->Mesh.EndVertex(dart).Value));
        }
        else if (!this->Mesh.IsOutside(across))
        {
          add(this->Find(across, to));
        }
      });
    return;
  }
  this->ForEachDart(from, id,
    [&](DartId dart)
    {
      add(this->Find(dart, to));
      if (from == Dart && to == Vertex)
      {
        add(static_cast<vtkIdType>(this->Mesh.EndVertex(dart).Value));
      }
    });
}

vtkCombinatorialMap::vtkCombinatorialMap() = default;
vtkCombinatorialMap::~vtkCombinatorialMap() = default;

namespace
{

/// Runs `work`; an exception becomes an error of `self`, and the result is false.
template <typename Work>
bool RunReported(vtkObject* self, Work&& work)
{
  try
  {
    work();
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(self, << error.what());
    return false;
  }
}

}

bool vtkCombinatorialMap::SetMesh(vtkUnstructuredGrid* mesh)
{
  this->Internals.reset();
  this->Modified();
  return RunReported(this,
    [&]
    {
      if (!mesh)
      {
        throw std::invalid_argument("There is no mesh: pass an unstructured grid.");
      }
      using Orientation = isthmus::GridCells::Orientation;
      const auto build = [&](Orientation orientation)
      {
        const isthmus::GridCells cells(mesh, orientation);
        if (isthmus::CompactCombinatorialMap<std::uint32_t>::FitsIn(cells.List()))
        {
          using Map = isthmus::CompactCombinatorialMap<std::uint32_t>;
          this->Internals = std::make_unique<vtkTypedInternals<Map>>(mesh, cells);
        }
        else
        {
          using Map = isthmus::CompactCombinatorialMap<std::uint64_t>;
          this->Internals = std::make_unique<vtkTypedInternals<Map>>(mesh, cells);
        }
        if (!cells.Remark().empty())
        {
          vtkWarningMacro(<< cells.Remark());
        }
      };
      try
      {
        build(Orientation::ByVolume);
      }
      catch (const isthmus::MeshError& error)
      {
        if (error.Kind() != isthmus::MeshError::Reason::Orientation)
        {
          throw;
        }
        build(Orientation::AsGiven); // as WithMap() does
      }
    });
}

vtkIdType vtkCombinatorialMap::GetNumber(int kind)
{
  vtkIdType number = 0;
  RunReported(this,
    [&]
    {
      RequireKind(kind);
      number = this->Internals ? this->Internals->Number(kind) : 0;
    });
  return number;
}

void vtkCombinatorialMap::GetIncident(int from, vtkIdType id, int to, vtkIdList* found)
{
  found->Reset();
  RunReported(this,
    [&]
    {
      RequireKind(from);
      RequireKind(to);
      std::vector<vtkIdType> ids;
      if (this->Internals)
      {
        this->Internals->Find(from, this->Internals->CheckId(from, id), to, ids);
      }
      for (const vtkIdType element : ids)
      {
        found->InsertNextId(element);
      }
    });
}

void vtkCombinatorialMap::GetIncidence(
  int from, int to, vtkIdTypeArray* offsets, vtkIdTypeArray* ids)
{
  offsets->Initialize();
  ids->Initialize();
  RunReported(this,
    [&]
    {
      RequireKind(from);
      RequireKind(to);
      std::vector<vtkIdType> found;
      offsets->InsertNextValue(0);
      for (vtkIdType i = 0; this->Internals && i < this->Internals->Number(from); ++i)
      {
        this->Internals->Find(from, i, to, found);
        for (const vtkIdType element : found)
        {
          ids->InsertNextValue(element);
        }
        offsets->InsertNextValue(ids->GetNumberOfValues());
      }
    });
}

void vtkCombinatorialMap::GetBeta(int dimension, vtkIdTypeArray* darts)
{
  darts->Initialize();
  RunReported(this,
    [&]
    {
      if (dimension < 1 || dimension > 3)
      {
        throw std::invalid_argument(
          "There is no beta_" + std::to_string(dimension) + ": choose 1, 2 or 3.");
      }
      for (vtkIdType i = 0; this->Internals && i < this->Internals->Number(Dart); ++i)
      {
        darts->InsertNextValue(this->Internals->Beta(dimension, i));
      }
    });
}

int vtkCombinatorialMap::GetNumberOfTables()
{
  return this->Internals ? static_cast<int>(this->Internals->Tables().size()) : 0;
}

const char* vtkCombinatorialMap::GetTableName(int table)
{
  const bool exists = table >= 0 && table < this->GetNumberOfTables();
  return exists ? this->Internals->Tables()[isthmus::At(table)].Name : nullptr;
}

vtkIdType vtkCombinatorialMap::GetTableBytes(int table)
{
  const bool exists = table >= 0 && table < this->GetNumberOfTables();
  return exists ? static_cast<vtkIdType>(this->Internals->Tables()[isthmus::At(table)].Bytes) : 0;
}

double vtkCombinatorialMap::GetEstimatedBytes()
{
  return this->Internals ? this->Internals->Estimate() : 0.0;
}

void vtkCombinatorialMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfCells: " << this->GetNumber(Cell) << "\n";
  os << indent << "NumberOfTables: " << this->GetNumberOfTables() << "\n";
}
