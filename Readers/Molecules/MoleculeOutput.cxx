#include "Molecules/MoleculeOutput.h"

#include "Atoms/ChemicalElement.h"
#include "Core/ArrayMemory.h"
#include "Core/LargePages.h"
#include "Core/NamedColumns.h"
#include "Core/ParallelFor.h"
#include "Core/PrintableText.h"
#include "Molecules/Macromolecule.h"

#include <vtkAbstractArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkMolecule.h>
#include <vtkMutableUndirectedGraph.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// An array that is created later, possibly in parallel with others. Null if there is no data.
using MakeArray = std::function<vtkSmartPointer<vtkAbstractArray>()>;

/// `value(atom)` of each atom.
template <typename Array, typename Value>
MakeArray Numbers(const Macromolecule& molecule, const char* name, Value value)
{
  return [&molecule, name, value]() -> vtkSmartPointer<vtkAbstractArray>
  {
    auto array = NamedArray<Array>(name, molecule.Atoms.size());
    AdviseLargePages(array.Get());
    std::transform(molecule.Atoms.begin(), molecule.Atoms.end(), array->GetPointer(0), value);
    return array;
  };
}

/// The same of a value that few files have; no array where it is NaN for all atoms.
template <typename Value>
MakeArray OptionalNumbers(const Macromolecule& molecule, const char* name, Value value)
{
  return [&molecule, name, value]() -> vtkSmartPointer<vtkAbstractArray>
  {
    if (std::all_of(molecule.Atoms.begin(), molecule.Atoms.end(),
          [&value](const Atom& atom) { return std::isnan(value(atom)); }))
    {
      return nullptr;
    }
    return Numbers<vtkDoubleArray>(molecule, name, value)();
  };
}

/// Secondary structure; no array where the file has none.
MakeArray Structures(const Macromolecule& molecule)
{
  return [&molecule]() -> vtkSmartPointer<vtkAbstractArray>
  {
    if (std::all_of(molecule.Atoms.begin(), molecule.Atoms.end(),
          [](const Atom& atom) { return atom.Structure == Atom::NoStructure; }))
    {
      return nullptr;
    }
    return Numbers<vtkUnsignedCharArray>(
      molecule, "SecondaryStructure", [](const Atom& a) { return a.Structure; })();
  };
}

template <typename Value>
MakeArray Texts(const Macromolecule& molecule, const char* name, Value value)
{
  return [&molecule, name, value]() -> vtkSmartPointer<vtkAbstractArray>
  {
    auto array = NamedArray<vtkStringArray>(name, molecule.Atoms.size());
    vtkStdString* next = array->GetPointer(0);
    for (const Atom& atom : molecule.Atoms)
    {
      next->assign(value(atom));
      ++next;
    }
    return array;
  };
}

/// A letter that most files leave blank; no array where all do.
template <typename Letter>
MakeArray Letters(const Macromolecule& molecule, const char* name, Letter letter)
{
  return [&molecule, name, letter]() -> vtkSmartPointer<vtkAbstractArray>
  {
    if (std::all_of(molecule.Atoms.begin(), molecule.Atoms.end(),
          [&](const Atom& atom) { return letter(atom) == ' '; }))
    {
      return nullptr;
    }
    return Texts(molecule, name,
      [letter](const Atom& atom)
      { return letter(atom) == ' ' ? std::string() : std::string(1, letter(atom)); })();
  };
}

constexpr std::size_t ElementPlace = 2; ///< among PointArrays

std::vector<MakeArray> PointArrays(const Macromolecule& molecule, bool withAltLoc)
{
  using Text = const std::string&;
  std::vector<MakeArray> arrays{
    Numbers<vtkDoubleArray>(molecule, "Radius", [](const Atom& a) { return a.Radius; }),
    Numbers<vtkDoubleArray>(molecule, "Charge", [](const Atom& a) { return a.Charge; }),
    Numbers<vtkUnsignedShortArray>(
      molecule, "Element", [](const Atom& a) { return static_cast<unsigned short>(a.Element); }),
    Texts(molecule, "AtomName", [](const Atom& a) -> Text { return a.Name; }),
    Texts(molecule, "ResidueName", [](const Atom& a) -> Text { return a.ResidueName; }),
    Numbers<vtkIntArray>(molecule, "ResidueId", [](const Atom& a) { return a.ResidueId; }),
    Texts(molecule, "Chain", [](const Atom& a) -> Text { return a.Chain; }),
    Numbers<vtkDoubleArray>(molecule, "BFactor", [](const Atom& a) { return a.BFactor; }),
    Numbers<vtkDoubleArray>(molecule, "Occupancy", [](const Atom& a) { return a.Occupancy; }),
    Numbers<vtkUnsignedCharArray>(molecule, "IsHetero",
      [](const Atom& a) { return static_cast<unsigned char>(a.IsHetero ? 1 : 0); }),
    Letters(molecule, "InsertionCode", [](const Atom& a) { return a.InsertionCode; }),
    OptionalNumbers(molecule, "pLDDT", [](const Atom& a) { return a.PLDDT; }), Structures(molecule)
  };
  if (withAltLoc)
  {
    arrays.push_back(Letters(molecule, "AltLoc", [](const Atom& a) { return a.AltLoc; }));
  }
  return arrays;
}

/// Calls all of `work`, several at once.
void RunAll(const std::vector<std::function<void()>>& work)
{
  ParallelFor(0, static_cast<std::int64_t>(work.size()), 1,
    [&work](std::int64_t first, std::int64_t last)
    {
      for (auto w = static_cast<std::size_t>(first); w < static_cast<std::size_t>(last); ++w)
      {
        work[w]();
      }
    });
}

vtkSmartPointer<vtkPoints> MakePoints(const Macromolecule& molecule)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  SizeArray(coordinates, static_cast<vtkIdType>(molecule.Atoms.size()));
  AdviseLargePages(coordinates.Get());
  double* next = coordinates->GetPointer(0);
  for (const Atom& atom : molecule.Atoms)
  {
    next = std::copy(atom.Position.begin(), atom.Position.end(), next);
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(coordinates);
  return points;
}

/// `count` cells of `size` points each, whose ids `point(i)` gives one after the other.
template <typename PointId>
void SetCells(vtkCellArray* cells, vtkIdType count, vtkIdType size, PointId point)
{
  vtkNew<vtkIdTypeArray> offsets;
  SizeArray(offsets, count + 1);
  vtkNew<vtkIdTypeArray> ids;
  SizeArray(ids, count * size);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, i * size);
  }
  for (vtkIdType i = 0; i < count * size; ++i)
  {
    ids->SetValue(i, point(i));
  }
  cells->SetData(offsets, ids);
}

void SetCells(const Macromolecule& molecule, vtkPolyData* to)
{
  const auto atoms = static_cast<vtkIdType>(molecule.Atoms.size());
  const auto bonds = static_cast<vtkIdType>(molecule.Bonds.size());
  vtkNew<vtkCellArray> vertices;
  SetCells(vertices, atoms, 1, [](vtkIdType i) { return i; });
  vtkNew<vtkCellArray> lines;
  SetCells(lines, bonds, 2,
    [&molecule](vtkIdType i)
    {
      const Bond& bond = molecule.Bonds[static_cast<std::size_t>(i / 2)];
      return static_cast<vtkIdType>(i % 2 == 0 ? bond.First : bond.Second);
    });
  to->SetVerts(vertices);
  to->SetLines(lines);
  auto* source = AddArray<vtkUnsignedCharArray>(
    to->GetCellData(), "BondSource", molecule.Atoms.size() + molecule.Bonds.size());
  unsigned char* next = std::fill_n(source->GetPointer(0), atoms, static_cast<unsigned char>(0));
  for (const Bond& bond : molecule.Bonds)
  {
    *next++ = bond.FromFile ? 1 : 2;
  }
}

void AddSentences(vtkFieldData* to, const char* name, const std::vector<std::string>& sentences)
{
  AddComputedColumn<vtkStringArray>(
    to, name, sentences, [](const std::string& sentence) { return Printable(sentence); });
}

void AddFacts(const Macromolecule& molecule, vtkFieldData* to)
{
  AddColumn<vtkIntArray>(to, "NumberOfModels", { molecule.NumberOfModels });
  std::vector<std::string> symbols(NumberOfElements);
  for (int element = 0; element < NumberOfElements; ++element)
  {
    symbols[static_cast<std::size_t>(element)] = ElementSymbol(element);
  }
  AddSentences(to, "ElementSymbols", symbols);
  if (molecule.Cell.size() == 3)
  {
    auto* vectors = AddArray<vtkDoubleArray>(to, "CellVectors", molecule.Cell.size(), 3);
    for (std::size_t k = 0; k < molecule.Cell.size(); ++k)
    {
      vectors->SetTypedTuple(static_cast<vtkIdType>(k), molecule.Cell[k].data());
    }
    if (!molecule.SpaceGroup.empty())
    {
      AddSentences(to, "SpaceGroup", { molecule.SpaceGroup });
    }
  }
  AddSentences(to, "Notes", molecule.Notes);
  AddSentences(to, "Warnings", molecule.Warnings);
}

/// The atoms of a molecule, but for its arrays other than the elements. As vtkMolecule::Initialize
/// does it, which adds each vertex alone.
void StartMolecule(vtkPoints* points, vtkDataArray* elements, vtkMolecule* molecule)
{
  vtkNew<vtkMutableUndirectedGraph> graph;
  graph->SetNumberOfVertices(points->GetNumberOfPoints());
  graph->SetPoints(points);
  vtkNew<vtkUnsignedShortArray> numbers;
  numbers->ShallowCopy(elements);
  numbers->SetName(molecule->GetAtomicNumberArrayName());
  graph->GetVertexData()->SetScalars(numbers);
  vtkNew<vtkUnsignedShortArray> orders;
  orders->SetName(molecule->GetBondOrdersArrayName());
  graph->GetEdgeData()->SetScalars(orders);
  if (!molecule->CheckedShallowCopy(graph))
  {
    throw std::runtime_error("VTK could not create a molecule from these atoms.");
  }
}

/// Its arrays, those of `atoms` and then VTK's own of the elements, as Initialize leaves them.
void FinishMolecule(const Macromolecule& from, vtkPolyData* atoms, vtkMolecule* molecule)
{
  const vtkSmartPointer<vtkDataArray> elements = molecule->GetAtomicNumberArray();
  molecule->GetVertexData()->ShallowCopy(atoms->GetPointData());
  molecule->GetVertexData()->AddArray(elements);
  for (const Bond& bond : from.Bonds)
  {
    molecule->AppendBond(bond.First, bond.Second);
  }
  molecule->GetFieldData()->ShallowCopy(atoms->GetFieldData());
}

}

void FillOutputs(
  const Macromolecule& from, bool withAltLoc, vtkPolyData* atoms, vtkMolecule* molecule)
{
  const std::vector<MakeArray> make = PointArrays(from, withAltLoc);
  std::vector<vtkSmartPointer<vtkAbstractArray>> arrays(make.size());
  const auto fill = [&make, &arrays](std::size_t i) { arrays[i] = make[i](); };
  vtkSmartPointer<vtkPoints> points;
  RunAll({ [&] { points = MakePoints(from); }, [&] { fill(ElementPlace); } });
  atoms->SetPoints(points);
  // VTK's part of the molecule takes longest and can't be divided, so it comes first.
  auto* const elements = vtkDataArray::SafeDownCast(arrays[ElementPlace]);
  std::vector<std::function<void()>> work{ [&] { StartMolecule(points, elements, molecule); },
    [&] { SetCells(from, atoms); } };
  for (std::size_t i = 0; i < make.size(); ++i)
  {
    if (i != ElementPlace)
    {
      work.emplace_back([&fill, i] { fill(i); });
    }
  }
  RunAll(work);
  for (const auto& array : arrays)
  {
    if (array)
    {
      atoms->GetPointData()->AddArray(array);
    }
  }
  AddFacts(from, atoms->GetFieldData());
  FinishMolecule(from, atoms, molecule);
}

}
