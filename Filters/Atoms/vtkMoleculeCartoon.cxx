#include "vtkMoleculeCartoon.h"

#include "Atoms/AtomRadii.h"
#include "Atoms/MoleculeAtoms.h"
#include "Atoms/PolymerResidues.h"
#include "Atoms/SecondaryStructure.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Core/GatherRanks.h"
#include "Core/MemoryBudget.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMoleculeCartoon);

const std::vector<isthmus::OutputArray>& vtkMoleculeCartoon::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Cells, "ResidueIndex", 1, "", ArrayChoice::None,
      "row of the residue in output 2" },
    { 0, ArrayPlace::Cells, "Residue", 1, "", ArrayChoice::None,
      "name, number and chain, e.g. LYS 48 A" },
    { 0, ArrayPlace::Cells, "ResidueId", 1, "", ArrayChoice::None, "number of the residue" },
    { 0, ArrayPlace::Cells, "ChainIndex", 1, "", ArrayChoice::None,
      "of the chain, in the order in which chains begin; ChainNames has the names" },
    { 0, ArrayPlace::Cells, "SecondaryStructure", 1, "", ArrayChoice::None,
      "0 coil, 1 alpha helix, 2 strand, 3 3-10 helix, 4 pi helix, 5 nucleic acid" },
    { 0, ArrayPlace::Cells, "BFactor", 1, "angstrom^2", ArrayChoice::None,
      "mean of the residue's atoms; where the input has it" },
    { 0, ArrayPlace::Cells, "pLDDT", 1, "", ArrayChoice::None,
      "mean of the residue's atoms; where the input has it" },
    { 0, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::None, "unit" },
    { 1, ArrayPlace::Cells, "Element", 1, "", ArrayChoice::None, "atomic number; 0: unknown" },
    { 1, ArrayPlace::Cells, "AtomName", 1, "", ArrayChoice::None, "of the atom" },
    { 1, ArrayPlace::Cells, "ResidueIndex", 1, "", ArrayChoice::None,
      "row of the residue in output 2" },
    { 1, ArrayPlace::Cells, "Residue", 1, "", ArrayChoice::None,
      "name, number and chain, e.g. LYS 48 A" },
    { 1, ArrayPlace::Cells, "ResidueId", 1, "", ArrayChoice::None, "number of the residue" },
    { 1, ArrayPlace::Cells, "ChainIndex", 1, "", ArrayChoice::None,
      "of the chain, in the order in which chains begin; ChainNames has the names" },
    { 1, ArrayPlace::Cells, "SecondaryStructure", 1, "", ArrayChoice::None,
      "0 coil, 1 alpha helix, 2 strand, 3 3-10 helix, 4 pi helix, 5 nucleic acid" },
    { 1, ArrayPlace::Cells, "BFactor", 1, "angstrom^2", ArrayChoice::None,
      "of the atom; where the input has it" },
    { 1, ArrayPlace::Cells, "pLDDT", 1, "", ArrayChoice::None,
      "of the atom; where the input has it" },
    { 1, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::None, "unit" },
    { 2, ArrayPlace::Points, "ResidueIndex", 1, "", ArrayChoice::None, "row of the residue" },
    { 2, ArrayPlace::Points, "Residue", 1, "", ArrayChoice::None,
      "name, number and chain, e.g. LYS 48 A" },
    { 2, ArrayPlace::Points, "ResidueId", 1, "", ArrayChoice::None, "number of the residue" },
    { 2, ArrayPlace::Points, "ChainIndex", 1, "", ArrayChoice::None,
      "of the chain, in the order in which chains begin; ChainNames has the names" },
    { 2, ArrayPlace::Points, "SecondaryStructure", 1, "", ArrayChoice::None,
      "0 coil, 1 alpha helix, 2 strand, 3 3-10 helix, 4 pi helix, 5 nucleic acid" },
    { 2, ArrayPlace::Points, "BFactor", 1, "angstrom^2", ArrayChoice::None,
      "mean of the residue's atoms; where the input has it" },
    { 2, ArrayPlace::Points, "pLDDT", 1, "", ArrayChoice::None,
      "mean of the residue's atoms; where the input has it" },
    { 2, ArrayPlace::Points, "ResidueName", 1, "", ArrayChoice::None, "of the residue" },
    { 2, ArrayPlace::Points, "Chain", 1, "", ArrayChoice::None, "name of the chain" },
    { 2, ArrayPlace::Points, "InsertionCode", 1, "", ArrayChoice::None,
      "of the residue; empty: none" },
    { -1, ArrayPlace::Field, "ChainNames", 1, "", ArrayChoice::None, "of ChainIndex" },
    { -1, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "where secondary structure is from, and what is not drawn" },
  };
  return table;
}

namespace
{

using isthmus::CartoonMesh;
using isthmus::CartoonShape;
using isthmus::DrawnBall;
using isthmus::NamedAtom;
using isthmus::PolymerResidue;
using isthmus::SecondaryStructure;
using isthmus::operator*;
using isthmus::operator+;

using Indices = std::vector<std::size_t>;

std::string MakeResidueLabel(const NamedAtom& atom)
{
  const std::string number =
    atom.Residue.empty() && atom.ResidueId == 0 ? "" : std::to_string(atom.ResidueId);
  std::string label = atom.Residue;
  for (const std::string& word : { number + atom.InsertionCode, atom.Chain })
  {
    label += (label.empty() || word.empty() ? "" : " ") + word;
  }
  return label;
}

/// Values of a point array of one component; none if there is no such array.
std::vector<double> Values(vtkPointSet* atoms, const char* name)
{
  vtkDataArray* array = atoms->GetPointData()->GetArray(name);
  std::vector<double> values;
  if (array && array->GetNumberOfComponents() == 1)
  {
    values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
    }
    values.resize(static_cast<std::size_t>(atoms->GetNumberOfPoints()),
      std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

double ComputeMean(const std::vector<double>& values, const Indices& atoms)
{
  double sum = 0.0;
  double count = 0.0;
  for (const std::size_t i : atoms)
  {
    if (!std::isnan(values[i]))
    {
      sum += values[i];
      count += 1.0;
    }
  }
  return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// All residues that are drawn: those of chains, then the others.
struct Residues
{
  std::vector<PolymerResidue> List;
  std::size_t OfChains = 0;
  std::vector<SecondaryStructure> Structure;
  std::vector<int> Chain;
  std::vector<std::string> ChainNames;
  std::vector<std::string> Labels;
};

void NameResidues(const std::vector<NamedAtom>& atoms, Residues& residues)
{
  std::map<std::string, int> numbers;
  for (const PolymerResidue& residue : residues.List)
  {
    const NamedAtom& atom = atoms[residue.Atoms.front()];
    const auto [at, isNew] =
      numbers.try_emplace(atom.Chain, static_cast<int>(residues.ChainNames.size()));
    if (isNew)
    {
      residues.ChainNames.push_back(atom.Chain);
    }
    residues.Chain.push_back(at->second);
    residues.Labels.push_back(MakeResidueLabel(atom));
  }
}

std::vector<SecondaryStructure> StructureFromFile(
  const std::vector<double>& values, const std::vector<PolymerResidue>& residues)
{
  std::vector<SecondaryStructure> structure;
  for (const PolymerResidue& residue : residues)
  {
    const std::int64_t atom = residue.Trace();
    const double value = values[atom >= 0 ? static_cast<std::size_t>(atom) : residue.Atoms.front()];
    const bool isKnown = value >= 0.0 && value <= 5.0 && value == std::floor(value);
    structure.push_back(residue.Kind == isthmus::ResidueKind::Nucleotide
        ? SecondaryStructure::NucleicAcid
        : isKnown ? static_cast<SecondaryStructure>(static_cast<unsigned char>(value))
                  : SecondaryStructure::Coil);
  }
  return structure;
}

void SetPolygons(const CartoonMesh& mesh, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(mesh.Points.size());
  vtkNew<vtkPoints> points; // single precision, as graphics cards have
  isthmus::SizePoints(points, count);
  auto* normals = isthmus::AddArray<vtkFloatArray>(output->GetPointData(), "Normals", 0);
  normals->SetNumberOfComponents(3);
  isthmus::SizeArray(normals, count);
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
    normals->SetTuple(static_cast<vtkIdType>(i), mesh.Normals[i].data());
  }
  output->SetPoints(points);
  output->GetPointData()->SetActiveNormals("Normals");
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> corners;
  isthmus::SizeArray(offsets, static_cast<vtkIdType>(mesh.Offsets.size()));
  isthmus::SizeArray(corners, static_cast<vtkIdType>(mesh.Corners.size()));
  std::copy(mesh.Offsets.begin(), mesh.Offsets.end(), offsets->GetPointer(0));
  std::copy(mesh.Corners.begin(), mesh.Corners.end(), corners->GetPointer(0));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, corners);
  output->SetPolys(polygons);
}

/// The arrays of residues, one value for each of `rows`: of(row) is its residue.
template <typename Of>
void AddResidueArrays(const std::vector<NamedAtom>& atoms, const Residues& residues,
  vtkFieldData* data, std::size_t rows, Of&& of)
{
  using isthmus::AddComputedColumn;
  AddComputedColumn<vtkIntArray>(
    data, "ResidueIndex", rows, [&](std::size_t row) { return static_cast<int>(of(row)); });
  AddComputedColumn<vtkStringArray>(
    data, "Residue", rows, [&](std::size_t row) { return residues.Labels[of(row)]; });
  AddComputedColumn<vtkIntArray>(data, "ResidueId", rows,
    [&](std::size_t row) { return atoms[residues.List[of(row)].Atoms.front()].ResidueId; });
  AddComputedColumn<vtkIntArray>(
    data, "ChainIndex", rows, [&](std::size_t row) { return residues.Chain[of(row)]; });
  AddComputedColumn<vtkUnsignedCharArray>(data, "SecondaryStructure", rows,
    [&](std::size_t row) { return static_cast<unsigned char>(residues.Structure[of(row)]); });
}

/// Means over the residues of an array of the atoms; nothing without it.
template <typename Of>
void AddMeans(vtkPointSet* atoms, const char* name, const Residues& residues, vtkFieldData* data,
  std::size_t rows, Of&& of)
{
  const std::vector<double> values = Values(atoms, name);
  if (values.empty())
  {
    return;
  }
  std::vector<double> means;
  for (const PolymerResidue& residue : residues.List)
  {
    means.push_back(ComputeMean(values, residue.Atoms));
  }
  isthmus::AddComputedColumn<vtkDoubleArray>(
    data, name, rows, [&](std::size_t row) { return means[of(row)]; });
}

void FillTable(vtkPointSet* input, const std::vector<NamedAtom>& atoms, const Residues& residues,
  vtkPolyData* output)
{
  const std::size_t rows = residues.List.size();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  isthmus::SizePoints(points, static_cast<vtkIdType>(rows));
  vtkNew<vtkCellArray> vertices;
  isthmus::ReserveCells(vertices, static_cast<vtkIdType>(rows), static_cast<vtkIdType>(rows));
  for (std::size_t r = 0; r < rows; ++r)
  {
    const PolymerResidue& residue = residues.List[r];
    isthmus::Point3 place{ 0.0, 0.0, 0.0 };
    for (const std::size_t i : residue.Atoms)
    {
      place = place + (1.0 / static_cast<double>(residue.Atoms.size())) * atoms[i].Place;
    }
    const bool hasTrace = r < residues.OfChains && residue.Kind != isthmus::ResidueKind::Other;
    place = hasTrace ? atoms[static_cast<std::size_t>(residue.Trace())].Place : place;
    const auto id = static_cast<vtkIdType>(r);
    points->SetPoint(id, place.data());
    vertices->InsertNextCell(1, &id);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  vtkPointData* data = output->GetPointData();
  const auto same = [](std::size_t row) { return row; };
  AddResidueArrays(atoms, residues, data, rows, same);
  AddMeans(input, "BFactor", residues, data, rows, same);
  AddMeans(input, "pLDDT", residues, data, rows, same);
  const auto text = [&](const char* name, std::string NamedAtom::*member)
  {
    isthmus::AddComputedColumn<vtkStringArray>(data, name, rows,
      [&](std::size_t row) { return atoms[residues.List[row].Atoms.front()].*member; });
  };
  text("ResidueName", &NamedAtom::Residue);
  text("Chain", &NamedAtom::Chain);
  text("InsertionCode", &NamedAtom::InsertionCode);
}

/// Bonds, the lines of the input, of which both ends are drawn.
std::vector<std::array<std::int64_t, 2>> CollectBonds(
  vtkPointSet* atoms, const std::vector<char>& isDrawn)
{
  std::vector<std::array<std::int64_t, 2>> bonds;
  auto* molecule = vtkPolyData::SafeDownCast(atoms);
  if (!molecule)
  {
    return bonds;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < molecule->GetNumberOfLines(); ++line)
  {
    molecule->GetLines()->GetCellAtId(line, ids);
    for (vtkIdType k = 0; k + 1 < ids->GetNumberOfIds(); ++k)
    {
      const vtkIdType a = ids->GetId(k);
      const vtkIdType b = ids->GetId(k + 1);
      if (isDrawn[static_cast<std::size_t>(a)] != 0 && isDrawn[static_cast<std::size_t>(b)] != 0)
      {
        bonds.push_back({ a, b });
      }
    }
  }
  return bonds;
}

/// Whether a residue is in the list: by name, number, or chain and number.
bool IsListed(const NamedAtom& atom, const std::set<std::string>& list)
{
  const std::string number = std::to_string(atom.ResidueId) + atom.InsertionCode;
  return list.count(atom.Residue) > 0 || list.count(number) > 0 ||
    list.count(atom.Chain + ":" + number) > 0;
}

double BallRadius(const NamedAtom& atom, bool isBonded, double scale, double stick)
{
  const double radius = isthmus::DefaultRadius(atom.Element);
  return std::max(stick, (isBonded ? 1.0 : 2.0) * scale * (std::isnan(radius) ? 1.7 : radius));
}

/// Half of the mesh's arrays are on its points: 162 points and 320 triangles of a ball, at most.
double CartoonBytes(std::size_t balls, std::size_t bonds, std::size_t residues, std::int64_t sides)
{
  return 60e3 * static_cast<double>(balls) +
    static_cast<double>(sides) *
    (400.0 * static_cast<double>(bonds) + 900.0 * static_cast<double>(residues));
}

}

vtkMoleculeCartoon::vtkMoleculeCartoon()
{
  this->SetNumberOfOutputPorts(3);
}

vtkPolyData* vtkMoleculeCartoon::GetSticks()
{
  return this->GetOutput(1);
}

vtkPolyData* vtkMoleculeCartoon::GetResidues()
{
  return this->GetOutput(2);
}

int vtkMoleculeCartoon::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkMoleculeCartoon::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      isthmus::Check(this->Parameters);
      vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
      isthmus::RequireOneRank(this, atoms, "atoms");
      if (atoms && atoms->GetNumberOfPoints() > 0)
      {
        this->Draw(atoms, outputVector);
      }
    });
}

void vtkMoleculeCartoon::Draw(vtkPointSet* input, vtkInformationVector* outputs)
{
  const std::vector<NamedAtom> atoms = isthmus::ReadNamedAtoms(input);
  this->UpdateProgress(0.1);
  std::vector<std::string> notes;

  // The parts that belong to chains, and the other parts that are drawn.
  isthmus::PolymerOptions options;
  isthmus::PolymerChoice chains = isthmus::ChoosePolymer(atoms, options);
  options.Ligands = this->IncludeLigands;
  options.Ions = this->IncludeIons;
  options.Waters = this->IncludeWaters;
  const isthmus::PolymerChoice all = isthmus::ChoosePolymer(atoms, options);
  notes = all.Notes;
  if (!chains.AnyChain)
  {
    chains.Kept.clear();
    notes.emplace_back(
      "No amino acid or nucleotide was recognised by its name: all atoms are balls and sticks.");
  }
  Indices others;
  std::set_difference(all.Kept.begin(), all.Kept.end(), chains.Kept.begin(), chains.Kept.end(),
    std::back_inserter(others));
  this->UpdateProgress(0.4);

  Residues residues;
  residues.List = isthmus::FindResidues(atoms, chains.Kept);
  residues.OfChains = residues.List.size();
  const std::vector<double> given = Values(input, "SecondaryStructure");
  const bool isGiven = !given.empty() && !this->ComputeSecondaryStructure;
  if (residues.OfChains > 0)
  {
    residues.Structure = isGiven ? StructureFromFile(given, residues.List)
                                 : isthmus::FindSecondaryStructure(atoms, residues.List);
    notes.emplace_back(isGiven ? "The secondary structure is the file's."
                               : "The secondary structure is DSSP's, by hydrogen bonds.");
  }
  const auto isWithoutTrace = [](const PolymerResidue& residue)
  { return residue.Kind == isthmus::ResidueKind::Other; };
  const auto untraced = std::count_if(residues.List.begin(), residues.List.end(), isWithoutTrace);
  if (untraced > 0)
  {
    notes.push_back(std::to_string(untraced) +
      " residues of chains have neither CA nor C4' nor P and are not in the cartoon.");
  }
  for (PolymerResidue& residue : isthmus::FindResidues(atoms, others))
  {
    residue.IsLinked = false;
    residues.List.push_back(std::move(residue));
  }
  residues.Structure.resize(residues.List.size(), SecondaryStructure::Coil);
  NameResidues(atoms, residues);
  this->UpdateProgress(0.6);

  // Balls and sticks.
  std::vector<std::size_t> residueOf(atoms.size(), 0);
  std::vector<char> isDrawn(atoms.size(), 0);
  const std::set<std::string> listed = isthmus::SplitNames(this->StickResidues);
  for (std::size_t r = 0; r < residues.List.size(); ++r)
  {
    const Indices& members = residues.List[r].Atoms;
    const bool isSticks = r >= residues.OfChains || IsListed(atoms[members.front()], listed);
    for (const std::size_t i : members)
    {
      residueOf[i] = r;
      isDrawn[i] = isSticks ? 1 : 0;
    }
  }
  const std::vector<std::array<std::int64_t, 2>> bonds = CollectBonds(input, isDrawn);
  std::vector<char> isBonded(atoms.size(), 0);
  for (const auto& [a, b] : bonds)
  {
    isBonded[static_cast<std::size_t>(a)] = isBonded[static_cast<std::size_t>(b)] = 1;
  }
  const CartoonShape& shape = this->Parameters;
  std::vector<DrawnBall> balls;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    if (isDrawn[i] != 0)
    {
      balls.push_back({ static_cast<std::int64_t>(i),
        BallRadius(atoms[i], isBonded[i] != 0, shape.BallScale, shape.StickRadius) });
    }
  }
  isthmus::MemoryBudget().Require(
    CartoonBytes(balls.size(), bonds.size(), residues.OfChains, shape.Sides),
    isthmus::JoinText("A cartoon of ", residues.OfChains, " residues and ", balls.size(), " balls"),
    "reduce Sides, or select fewer atoms");
  CartoonMesh cartoon;
  CartoonMesh sticks;
  const isthmus::ProgressCallback progress = isthmus::MakeProgress(this);
  const std::vector<PolymerResidue> ofChains(
    residues.List.begin(), residues.List.begin() + static_cast<std::ptrdiff_t>(residues.OfChains));
  isthmus::DrawCartoon(
    atoms, ofChains, residues.Structure, shape, cartoon, isthmus::Between(progress, 0.6, 0.8));
  isthmus::DrawBallsAndSticks(
    atoms, balls, bonds, shape, sticks, isthmus::Between(progress, 0.8, 0.9));

  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  SetPolygons(cartoon, output);
  const auto residueOfPolygon = [&](std::size_t p)
  { return static_cast<std::size_t>(cartoon.Items[p]); };
  vtkCellData* data = output->GetCellData();
  AddResidueArrays(atoms, residues, data, cartoon.NumberOfPolygons(), residueOfPolygon);
  AddMeans(input, "BFactor", residues, data, cartoon.NumberOfPolygons(), residueOfPolygon);
  AddMeans(input, "pLDDT", residues, data, cartoon.NumberOfPolygons(), residueOfPolygon);

  vtkPolyData* second = vtkPolyData::GetData(outputs, 1);
  SetPolygons(sticks, second);
  const auto atomOf = [&](std::size_t p) { return static_cast<std::size_t>(sticks.Items[p]); };
  const std::size_t polygons = sticks.NumberOfPolygons();
  data = second->GetCellData();
  isthmus::AddComputedColumn<vtkUnsignedShortArray>(data, "Element", polygons,
    [&](std::size_t p) { return static_cast<unsigned short>(atoms[atomOf(p)].Element); });
  isthmus::AddComputedColumn<vtkStringArray>(
    data, "AtomName", polygons, [&](std::size_t p) { return atoms[atomOf(p)].Name; });
  AddResidueArrays(
    atoms, residues, data, polygons, [&](std::size_t p) { return residueOf[atomOf(p)]; });
  for (const char* name : { "BFactor", "pLDDT" })
  {
    const std::vector<double> values = Values(input, name);
    if (!values.empty())
    {
      isthmus::AddComputedColumn<vtkDoubleArray>(
        data, name, polygons, [&](std::size_t p) { return values[atomOf(p)]; });
    }
  }

  FillTable(input, atoms, residues, vtkPolyData::GetData(outputs, 2));
  for (int port = 0; port < 3; ++port)
  {
    vtkDataObject* to = vtkDataObject::GetData(outputs, port);
    to->GetFieldData()->PassData(input->GetFieldData());
    isthmus::AddColumn<vtkStringArray>(to->GetFieldData(), "ChainNames", residues.ChainNames);
    isthmus::AddNotes(notes, to);
  }
}

void vtkMoleculeCartoon::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ComputeSecondaryStructure: " << this->ComputeSecondaryStructure << "\n";
  os << indent << "IncludeLigands: " << this->IncludeLigands << "\n";
  os << indent << "IncludeIons: " << this->IncludeIons << "\n";
  os << indent << "IncludeWaters: " << this->IncludeWaters << "\n";
  os << indent << "StickResidues: " << this->StickResidues << "\n";
  os << indent << "RibbonWidth: " << this->GetRibbonWidth() << "\n";
  os << indent << "RibbonThickness: " << this->GetRibbonThickness() << "\n";
  os << indent << "StickRadius: " << this->GetStickRadius() << "\n";
  os << indent << "BallScale: " << this->GetBallScale() << "\n";
  os << indent << "Sides: " << this->GetSides() << "\n";
}
