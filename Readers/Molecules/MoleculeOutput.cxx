#include "MoleculeOutput.h"

#include "ChemicalElement.h"
#include "Macromolecule.h"
#include "PrintableText.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkMolecule.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// Adds `value(atom)` of each atom as an array.
template <typename Array, typename Value>
void AddNumbers(const Macromolecule& molecule, const char* name, vtkPolyData* to, Value value)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(molecule.Atoms.size()));
  std::transform(
    molecule.Atoms.begin(), molecule.Atoms.end(), array->GetPointer(0), std::move(value));
  to->GetPointData()->AddArray(array);
}

template <typename Value>
void AddTexts(const Macromolecule& molecule, const char* name, vtkPolyData* to, Value value)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(molecule.Atoms.size()));
  vtkStdString* next = array->GetPointer(0);
  for (const Atom& atom : molecule.Atoms)
  {
    next->assign(value(atom));
    ++next;
  }
  to->GetPointData()->AddArray(array);
}

/// A letter that most files leave blank; no array where all do.
template <typename Letter>
void AddLetters(const Macromolecule& molecule, const char* name, vtkPolyData* to, Letter letter)
{
  if (std::any_of(molecule.Atoms.begin(), molecule.Atoms.end(),
        [&](const Atom& atom) { return letter(atom) != ' '; }))
  {
    AddTexts(molecule, name, to,
      [&](const Atom& atom)
      { return letter(atom) == ' ' ? std::string() : std::string(1, letter(atom)); });
  }
}

void AddPointArrays(const Macromolecule& molecule, bool withAltLoc, vtkPolyData* to)
{
  AddNumbers<vtkDoubleArray>(molecule, "Radius", to, [](const Atom& a) { return a.Radius; });
  AddNumbers<vtkDoubleArray>(molecule, "Charge", to, [](const Atom& a) { return a.Charge; });
  AddNumbers<vtkUnsignedShortArray>(
    molecule, "Element", to, [](const Atom& a) { return static_cast<unsigned short>(a.Element); });
  using Text = const std::string&;
  AddTexts(molecule, "AtomName", to, [](const Atom& a) -> Text { return a.Name; });
  AddTexts(molecule, "ResidueName", to, [](const Atom& a) -> Text { return a.ResidueName; });
  AddNumbers<vtkIntArray>(molecule, "ResidueId", to, [](const Atom& a) { return a.ResidueId; });
  AddTexts(molecule, "Chain", to, [](const Atom& a) -> Text { return a.Chain; });
  AddNumbers<vtkDoubleArray>(molecule, "BFactor", to, [](const Atom& a) { return a.BFactor; });
  AddNumbers<vtkDoubleArray>(molecule, "Occupancy", to, [](const Atom& a) { return a.Occupancy; });
  AddNumbers<vtkUnsignedCharArray>(molecule, "IsHetero", to,
    [](const Atom& a) { return static_cast<unsigned char>(a.IsHetero ? 1 : 0); });
  AddLetters(molecule, "InsertionCode", to, [](const Atom& a) { return a.InsertionCode; });
  if (withAltLoc)
  {
    AddLetters(molecule, "AltLoc", to, [](const Atom& a) { return a.AltLoc; });
  }
}

/// `count` cells of `size` points each, whose ids `point(i)` gives one after the other.
template <typename PointId>
void SetCells(vtkCellArray* cells, vtkIdType count, vtkIdType size, PointId point)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetNumberOfValues(count * size);
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
  vtkNew<vtkUnsignedCharArray> source;
  source->SetName("BondSource");
  source->SetNumberOfValues(atoms + bonds);
  unsigned char* next = std::fill_n(source->GetPointer(0), atoms, static_cast<unsigned char>(0));
  for (const Bond& bond : molecule.Bonds)
  {
    *next++ = bond.FromFile ? 1 : 2;
  }
  to->GetCellData()->AddArray(source);
}

void AddSentences(vtkFieldData* to, const char* name, const std::vector<std::string>& sentences)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& sentence : sentences)
  {
    array->InsertNextValue(Printable(sentence));
  }
  to->AddArray(array);
}

void AddFieldData(const Macromolecule& molecule, vtkFieldData* to)
{
  vtkNew<vtkIntArray> models;
  models->SetName("NumberOfModels");
  models->InsertNextValue(static_cast<int>(molecule.NumberOfModels));
  to->AddArray(models);
  std::vector<std::string> symbols(NumberOfElements);
  for (int element = 0; element < NumberOfElements; ++element)
  {
    symbols[static_cast<std::size_t>(element)] = ElementSymbol(element);
  }
  AddSentences(to, "ElementSymbols", symbols);
  AddSentences(to, "Notes", molecule.Notes);
  AddSentences(to, "Warnings", molecule.Warnings);
}

}

void FillAtoms(const Macromolecule& molecule, bool withAltLoc, vtkPolyData* atoms)
{
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(molecule.Atoms.size()));
  double* next = coordinates->GetPointer(0);
  for (const Atom& atom : molecule.Atoms)
  {
    next = std::copy(atom.Position.begin(), atom.Position.end(), next);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  atoms->SetPoints(points);
  SetCells(molecule, atoms);
  AddPointArrays(molecule, withAltLoc, atoms);
  AddFieldData(molecule, atoms->GetFieldData());
}

void FillMolecule(const Macromolecule& from, vtkPolyData* atoms, vtkMolecule* molecule)
{
  if (!molecule->Initialize(
        atoms->GetPoints(), atoms->GetPointData()->GetArray("Element"), atoms->GetPointData()))
  {
    throw std::runtime_error("VTK could not make a molecule of these atoms.");
  }
  for (const Bond& bond : from.Bonds)
  {
    molecule->AppendBond(bond.First, bond.Second);
  }
  molecule->GetFieldData()->ShallowCopy(atoms->GetFieldData());
}

}
