#include "vtkMolecularPockets.h"

#include "Atoms/PeriodicCell.h"
#include "Core/AlgorithmGuard.h"
#include "Core/Cached.h"
#include "Core/GatherRanks.h"
#include "Core/NamedColumns.h"
#include "Core/PolyDataTriangles.h"
#include "Pockets/LiningResidues.h"
#include "Pockets/LongTriangulation.h"
#include "Pockets/MolecularPockets.h"
#include "Pockets/PocketOutput.h"
#include "Pockets/PocketScore.h"
#include "Pockets/SiteDescriptors.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

vtkStandardNewMacro(vtkMolecularPockets);

namespace
{

/// The word (SiteAtom) of each residue, given in ascending order.
std::vector<std::int64_t> FindWords(const std::vector<isthmus::ResidueWord>& sequence)
{
  constexpr std::size_t around = 3;
  std::map<std::string, std::int64_t> known;
  std::vector<std::int64_t> words;
  words.reserve(sequence.size());
  for (std::size_t i = 0; i < sequence.size(); ++i)
  {
    std::string word;
    for (std::size_t k = i + 1 > around ? i - around : 0;
         k < std::min(i + around + 1, sequence.size()); ++k)
    {
      const bool sameChain = std::get<0>(sequence[k]) == std::get<0>(sequence[i]);
      word += (sameChain ? std::get<3>(sequence[k]) : std::string()) + " ";
    }
    words.push_back(known.emplace(word, static_cast<std::int64_t>(known.size())).first->second);
  }
  return words;
}

/// The heavy atoms with their properties for binding; empty without names and elements.
std::vector<isthmus::SiteAtom> MakeSiteAtoms(const isthmus::MoleculeAtoms& atoms)
{
  std::vector<isthmus::SiteAtom> found;
  if (!atoms.HasNames || !atoms.HasElements)
  {
    return found;
  }
  const auto residueOf = [](const isthmus::NamedAtom& named) {
    return isthmus::ResidueWord(named.Chain, named.ResidueId, named.InsertionCode, named.Residue);
  };
  std::map<std::string, int> chains;
  std::map<isthmus::ResidueWord, std::int64_t> residues;
  for (const std::int64_t point : atoms.Points)
  {
    const isthmus::NamedAtom& named = atoms.Named[static_cast<std::size_t>(point)];
    chains[named.Chain] = 0;
    residues[residueOf(named)] = 0;
  }
  int number = 0;
  for (auto& chain : chains)
  {
    chain.second = number++;
  }
  std::vector<isthmus::ResidueWord> sequence;
  for (auto& residue : residues)
  {
    residue.second = static_cast<std::int64_t>(sequence.size());
    sequence.push_back(residue.first);
  }
  const std::vector<std::int64_t> words = FindWords(sequence);
  for (std::size_t i = 0; i < atoms.Balls.size(); ++i)
  {
    const isthmus::NamedAtom& named = atoms.Named[static_cast<std::size_t>(atoms.Points[i])];
    if (named.Element > 1)
    {
      found.push_back(
        isthmus::MakeSiteAtom(atoms.Balls[i].Center, named.Element, named.Residue, named.Name));
      found.back().Chain = chains[named.Chain];
      found.back().Number = residues[residueOf(named)];
      found.back().Word = words[static_cast<std::size_t>(found.back().Number)];
    }
  }
  return found;
}

/// The residues that line each site, those with most surface first.
std::vector<isthmus::SiteName> MakeSiteNames(
  const std::vector<isthmus::Pocket>& sites, const isthmus::MoleculeAtoms& atoms)
{
  std::vector<isthmus::SiteName> names;
  for (const isthmus::Pocket& site : sites)
  {
    std::vector<isthmus::LiningResidue> residues = isthmus::FindLiningResidues(site.Lining, atoms);
    std::stable_sort(residues.begin(), residues.end(),
      [](const isthmus::LiningResidue& a, const isthmus::LiningResidue& b)
      { return a.Area > b.Area; });
    names.emplace_back();
    for (const isthmus::LiningResidue& residue : residues)
    {
      const auto& atom = atoms.Named[static_cast<std::size_t>(residue.Points.front())];
      names.back().emplace_back(atom.Chain, atom.ResidueId, atom.InsertionCode, atom.Residue);
    }
  }
  return names;
}

/// The atoms to which the pockets of a crystal refer.
void TakeCopies(const isthmus::PocketResult& result, isthmus::MoleculeAtoms& atoms)
{
  std::vector<isthmus::Ball> balls;
  std::vector<vtkIdType> points;
  for (std::size_t i = 0; i < result.Copies.size(); ++i)
  {
    const auto atom = static_cast<std::size_t>(result.CopyAtoms[i]);
    balls.push_back({ result.Copies[i], atoms.Balls[atom].Radius });
    points.push_back(atoms.Points[atom]);
  }
  atoms.Balls = std::move(balls);
  atoms.Points = std::move(points);
}

/// The numbers of a surface's point array; empty if it is missing and not required.
std::vector<double> ReadNumbers(const std::string& name, vtkPolyData* surface, bool required)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    if (required)
    {
      throw std::invalid_argument("The surface has no point array " + name +
        " with one number per point: create it with vtkPolarizedCurvature, or choose another "
        "array.");
    }
    return {};
  }
  std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return values;
}

}

class vtkMolecularPockets::vtkInternals
{
public:
  using Key = std::tuple<isthmus::ObjectState, std::string, std::array<double, 5>,
    std::array<bool, 8>, std::string>;
  isthmus::Cached<Key, isthmus::PocketResult> Pockets;
};

vtkMolecularPockets::~vtkMolecularPockets() = default;

const std::vector<isthmus::OutputArray>& vtkMolecularPockets::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "AtomId", 1, "", ArrayChoice::None, "the point of the input" },
    { 0, ArrayPlace::Cells, "PocketId", 1, "", ArrayChoice::None,
      "rank of the pocket; the best has 1" },
    { 0, ArrayPlace::Cells, "Clearance", 1, "angstrom", ArrayChoice::None,
      "radius of the ball there that touches no atom" },
    { 0, ArrayPlace::Cells, "AccessRadius", 1, "angstrom", ArrayChoice::None,
      "of the largest ball that gets there from outside" },
    { 0, ArrayPlace::Cells, "Burial", 1, "", ArrayChoice::None, "atoms within BurialRadius" },
    { 0, ArrayPlace::Cells, "EmptyVolume", 1, "angstrom^3", ArrayChoice::None,
      "only sums are meaningful; at least 0 in a site" },
    { 0, ArrayPlace::Cells, "SiteProbability", 1, "", ArrayChoice::None,
      "probability that a ligand's atom is within 3 angstrom of the ball's center; 0 without "
      "sites" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None, "what was dropped from the input" },
    { 1, ArrayPlace::Rows, "Rank", 1, "", ArrayChoice::None, "of the pocket; the best has 1" },
    { 1, ArrayPlace::Rows, "Probability", 1, "", ArrayChoice::None,
      "that the center is within 4 angstrom of a ligand; NaN without sites" },
    { 1, ArrayPlace::Rows, "Score", 1, "angstrom^3", ArrayChoice::None, "volume x (atoms/100)^2" },
    { 1, ArrayPlace::Rows, "CenterX", 1, "angstrom", ArrayChoice::None, "center of the pocket" },
    { 1, ArrayPlace::Rows, "CenterY", 1, "angstrom", ArrayChoice::None, "center of the pocket" },
    { 1, ArrayPlace::Rows, "CenterZ", 1, "angstrom", ArrayChoice::None, "center of the pocket" },
    { 1, ArrayPlace::Rows, "Volume", 1, "angstrom^3", ArrayChoice::None,
      "accessible to the probe's center" },
    { 1, ArrayPlace::Rows, "Area", 1, "angstrom^2", ArrayChoice::None,
      "accessible to the probe's center" },
    { 1, ArrayPlace::Rows, "Mouths", 1, "", ArrayChoice::None, "their number; 0: a void" },
    { 1, ArrayPlace::Rows, "MouthRadius", 1, "angstrom", ArrayChoice::None, "of the widest" },
    { 1, ArrayPlace::Rows, "MouthArea", 1, "angstrom^2", ArrayChoice::None, "of all mouths" },
    { 1, ArrayPlace::Rows, "Radius", 1, "angstrom", ArrayChoice::None, "of the largest ball" },
    { 1, ArrayPlace::Rows, "PolarShare", 1, "", ArrayChoice::None, "fraction of Area on N and O" },
    { 1, ArrayPlace::Rows, "ApolarShare", 1, "", ArrayChoice::None,
      "fraction of Area on other atoms" },
    { 1, ArrayPlace::Rows, "LiningAtoms", 1, "", ArrayChoice::None, "their number" },
    { 1, ArrayPlace::Rows, "Cells", 1, "", ArrayChoice::None, "number of tetrahedra" },
    { 1, ArrayPlace::Rows, "Parent", 1, "", ArrayChoice::None,
      "pocket of a site; 0: in no pocket" },
    { 1, ArrayPlace::Rows, "CopyOf", 1, "", ArrayChoice::None,
      "rank of the first of the sites at this place in copies of the chain, or the site's own rank "
      "if it is the first; 0 without sites" },
    { 1, ArrayPlace::Rows, "MeanPotential", 1, "kT/e", ArrayChoice::None,
      "mean of the surface's potential" },
    { 1, ArrayPlace::Rows, "MeanPolarized", 1, "kT/(e angstrom)", ArrayChoice::None,
      "mean of the absolute polarized curvature" },
    { 1, ArrayPlace::Rows, "Residues", 1, "", ArrayChoice::None,
      "names of the lining residues, those with the largest area first" },
    { 1, ArrayPlace::Field, "AccessibleArea", 1, "angstrom^2", ArrayChoice::None,
      "of the whole molecule" },
    { 1, ArrayPlace::Field, "AccessibleVolume", 1, "angstrom^3", ArrayChoice::None,
      "of the whole molecule" },
    { 1, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None, "what was dropped from the input" },
    { 2, ArrayPlace::Points, "AtomId", 1, "", ArrayChoice::None, "the point of the input" },
    { 2, ArrayPlace::Cells, "PocketId", 1, "", ArrayChoice::None, "of the mouth" },
    { 2, ArrayPlace::Cells, "MouthId", 1, "", ArrayChoice::None, "number of the mouth" },
    { 2, ArrayPlace::Cells, "Clearance", 1, "angstrom", ArrayChoice::None, "of the triangle" },
    { 3, ArrayPlace::Points, "PocketId", 1, "", ArrayChoice::None, "of the ball" },
    { 3, ArrayPlace::Points, "Radius", 1, "angstrom", ArrayChoice::None, "of the ball" },
    { 3, ArrayPlace::Points, "AccessRadius", 1, "angstrom", ArrayChoice::None,
      "of the largest ball that gets there from outside" },
    { 3, ArrayPlace::Points, "Burial", 1, "", ArrayChoice::None, "atoms within BurialRadius" },
    { 4, ArrayPlace::Rows, "PocketId", 1, "", ArrayChoice::None,
      "of the pocket that the residue lines" },
    { 4, ArrayPlace::Rows, "Chain", 1, "", ArrayChoice::None, "of the residue" },
    { 4, ArrayPlace::Rows, "ResidueId", 1, "", ArrayChoice::None, "number of the residue" },
    { 4, ArrayPlace::Rows, "InsertionCode", 1, "", ArrayChoice::None, "of the residue" },
    { 4, ArrayPlace::Rows, "ResidueName", 1, "", ArrayChoice::None, "of the residue" },
    { 4, ArrayPlace::Rows, "Atoms", 1, "", ArrayChoice::None, "names of the lining atoms" },
    { 4, ArrayPlace::Rows, "AtomIds", 1, "", ArrayChoice::None, "points of the input" },
    { 4, ArrayPlace::Rows, "NumberOfAtoms", 1, "", ArrayChoice::None, "lining atoms" },
    { 4, ArrayPlace::Rows, "Area", 1, "angstrom^2", ArrayChoice::None,
      "of the residue in the pocket" },
    { 5, ArrayPlace::Points, "PocketId", 1, "", ArrayChoice::None,
      "of the pocket that the residue lines" },
    { 5, ArrayPlace::Points, "ResidueLabel", 1, "", ArrayChoice::None,
      "name and number of the residue, at one of its atoms" },
    { 6, ArrayPlace::Points, "PocketId", 1, "", ArrayChoice::None, "0: none; with input 1" },
    { 6, ArrayPlace::Points, "SiteProbability", 1, "", ArrayChoice::None,
      "probability of a site at the point" },
    { 6, ArrayPlace::Points, "SiteDescriptors", 83, "", ArrayChoice::Off,
      "numbers from which the probability is computed; without input 1" },
  };
  return table;
}

vtkMolecularPockets::vtkMolecularPockets()
  : OutputArrays(this, OutputArrayTable())
  , Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(7);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
}

void vtkMolecularPockets::SetSurfaceData(vtkPolyData* surface)
{
  this->SetInputData(1, surface);
}

vtkTable* vtkMolecularPockets::GetPocketTable()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

vtkPolyData* vtkMolecularPockets::GetMouths()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

vtkPolyData* vtkMolecularPockets::GetAlphaBalls()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(3));
}

vtkTable* vtkMolecularPockets::GetLiningResidues()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(4));
}

vtkPolyData* vtkMolecularPockets::GetLiningAtoms()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(5));
}

vtkPolyData* vtkMolecularPockets::GetSiteSurface()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(6));
}

int vtkMolecularPockets::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port == 0 ? 0 : 1);
  return 1;
}

int vtkMolecularPockets::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkUnstructuredGrid", "vtkTable", "vtkPolyData", "vtkPolyData",
    "vtkTable", "vtkPolyData", "vtkPolyData" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

int vtkMolecularPockets::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* atoms = vtkPointSet::GetData(inputVector[0], 0);
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[1], 0);
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      this->OutputArrays.Check();
      isthmus::RequireOneRank(this, atoms, "atoms");
      if (atoms)
      {
        this->Compute(atoms, surface, outputVector);
      }
      isthmus::Report(isthmus::MakeProgress(this), 1.0);
    });
}

void vtkMolecularPockets::Compute(
  vtkPointSet* input, vtkPolyData* surface, vtkInformationVector* outputs)
{
  isthmus::PolymerOptions keep;
  keep.Hydrogens = this->IncludeHydrogens;
  keep.Waters = this->IncludeWaters;
  keep.Ions = this->IncludeIons;
  keep.Ligands = this->IncludeLigands;
  keep.ProstheticGroups = this->IncludeProstheticGroups;
  keep.Residues = isthmus::SplitNames(this->IncludeResidues);
  isthmus::PocketOptions options = this->Parameters;
  isthmus::Check(options);
  options.Predicted = isthmus::WarnAboutLongTriangulation(this);
  isthmus::AtomOptions which = isthmus::SelectPolymer(isthmus::InputArrayName(this, 0), keep);
  which.MinimumConfidence = this->MinimumConfidence;
  isthmus::MoleculeAtoms atoms = isthmus::ReadAtoms(input, which);
  if (this->UsePeriodicCell)
  {
    options.Cell = isthmus::ReadPeriodicCell(input, atoms.Warnings).GetVectors();
  }
  const std::vector<isthmus::SiteAtom> siteAtoms = MakeSiteAtoms(atoms);
  if (this->FindSites && !this->UsePeriodicCell && !siteAtoms.empty())
  {
    options.SiteAtoms = &siteAtoms;
    options.KeepDescriptors = this->OutputArrays.Has("SiteDescriptors");
  }
  // Pockets of any volume are kept, so that changing the threshold of whole pockets is instant.
  const double least = std::exchange(options.MinimumVolume, 0.0);
  const vtkInternals::Key key{ isthmus::GetState(input), isthmus::InputArrayName(this, 0),
    { options.ProbeRadius, options.InnerRadius, options.OuterRadius, options.BurialRadius,
      this->MinimumConfidence },
    { this->FindSites, this->UsePeriodicCell, options.KeepDescriptors, keep.Hydrogens, keep.Waters,
      keep.Ions, keep.Ligands, keep.ProstheticGroups },
    this->IncludeResidues };
  isthmus::PocketResult result = this->Internals->Pockets.Get(key,
    [&]
    {
      return isthmus::FindPockets(
        atoms.Balls, options, isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.9));
    });
  if (!options.SiteAtoms)
  {
    std::vector<isthmus::Pocket>& pockets = result.Pockets;
    pockets.erase(std::remove_if(pockets.begin(), pockets.end(),
                    [least](const isthmus::Pocket& pocket) { return pocket.Volume < least; }),
      pockets.end());
  }
  if (options.SiteAtoms)
  {
    isthmus::OrderTiedSites(MakeSiteNames(result.Pockets, atoms), result.Pockets);
  }
  if (this->UsePeriodicCell)
  {
    TakeCopies(result, atoms);
  }
  std::vector<isthmus::PocketSurfaceMeans> means;
  const bool hasSurface = surface && surface->GetNumberOfPoints() > 0;
  // A surface on which sites are shown need not have polarized curvature.
  if (hasSurface && this->UsePolarizedCurvature &&
    (!options.SiteAtoms || surface->GetPointData()->HasArray(this->PolarizedArrayName.c_str())))
  {
    const isthmus::PolyDataTriangles triangles(surface);
    const isthmus::PocketSurfaceFields fields{ ReadNumbers(this->PolarizedArrayName, surface, true),
      ReadNumbers(this->PotentialArrayName, surface, false) };
    isthmus::WeightScoresByCurvature(
      triangles.View(), fields, !options.SiteAtoms, result.Pockets, means);
  }
  const isthmus::PocketReport report{ result.Pockets, means, atoms };
  auto* cells = vtkUnstructuredGrid::GetData(outputs, 0);
  auto* table = vtkTable::GetData(outputs, 1);
  isthmus::FillPocketCells(report, cells);
  isthmus::FillPocketTable(report, table);
  isthmus::FillMouths(report, vtkPolyData::GetData(outputs, 2));
  isthmus::FillAlphaBalls(report, vtkPolyData::GetData(outputs, 3));
  isthmus::FillLiningResidues(report, vtkTable::GetData(outputs, 4));
  isthmus::FillLiningAtoms(report, input, this->ShownPocket, vtkPolyData::GetData(outputs, 5));
  isthmus::FillSiteSurface(
    report, result.SitePlaces, hasSurface ? surface : nullptr, vtkPolyData::GetData(outputs, 6));
  isthmus::AddColumn<vtkDoubleArray>(table->GetFieldData(), "AccessibleArea", { result.UnionArea });
  isthmus::AddColumn<vtkDoubleArray>(
    table->GetFieldData(), "AccessibleVolume", { result.UnionVolume });
  isthmus::AddNotes(atoms.Notes, cells);
  isthmus::AddNotes(atoms.Notes, table);
  for (const std::string& warning : atoms.Warnings)
  {
    vtkWarningMacro(<< warning);
  }
  const std::string confidence = result.Pockets.empty()
    ? std::string()
    : isthmus::DescribeConfidence(
        isthmus::FindLiningResidues(result.Pockets.front().Lining, atoms), atoms, "the first site");
  if (!confidence.empty())
  {
    vtkWarningMacro(<< confidence);
  }
}

void vtkMolecularPockets::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProbeRadius: " << this->GetProbeRadius() << "\n";
  os << indent << "InnerRadius: " << this->GetInnerRadius() << "\n";
  os << indent << "OuterRadius: " << this->GetOuterRadius() << "\n";
  os << indent << "BurialRadius: " << this->GetBurialRadius() << "\n";
  os << indent << "MinimumVolume: " << this->GetMinimumVolume() << "\n";
  os << indent << "FindSites: " << this->FindSites << "\n";
  this->OutputArrays.Print(os, indent);
  os << indent << "UsePeriodicCell: " << this->UsePeriodicCell << "\n";
  os << indent << "UsePolarizedCurvature: " << this->UsePolarizedCurvature << "\n";
  os << indent << "PolarizedArrayName: " << this->PolarizedArrayName << "\n";
  os << indent << "PotentialArrayName: " << this->PotentialArrayName << "\n";
  os << indent << "IncludeHydrogens: " << this->IncludeHydrogens << "\n";
  os << indent << "IncludeWaters: " << this->IncludeWaters << "\n";
  os << indent << "IncludeIons: " << this->IncludeIons << "\n";
  os << indent << "IncludeLigands: " << this->IncludeLigands << "\n";
  os << indent << "MinimumConfidence: " << this->MinimumConfidence << "\n";
  os << indent << "IncludeProstheticGroups: " << this->IncludeProstheticGroups << "\n";
  os << indent << "IncludeResidues: " << this->IncludeResidues << "\n";
  os << indent << "ShownPocket: " << this->ShownPocket << "\n";
}
