#include "Pockets/BindingSiteTable.h"

#include "Atoms/PointBins.h"
#include "Core/NamedColumns.h"
#include "Pockets/LiningResidues.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace isthmus
{
namespace
{

/// A residue near a site: its first atom, which provides its name, and the number of its atoms.
struct NearResidue
{
  std::size_t First;
  int Atoms = 0;
};

/// Residues by their identity.
using NearResidues = std::map<std::tuple<std::string, int, std::string, std::string>, NearResidue>;

std::string JoinResidueNames(const NearResidues& residues, const MoleculeAtoms& atoms)
{
  std::vector<NearResidue> sorted;
  for (const auto& [key, residue] : residues)
  {
    sorted.push_back(residue);
  }
  std::sort(sorted.begin(), sorted.end(),
    [](const NearResidue& a, const NearResidue& b)
    { return a.Atoms != b.Atoms ? a.Atoms > b.Atoms : a.First < b.First; });
  std::string text;
  for (const NearResidue& residue : sorted)
  {
    const std::string count = std::to_string(residue.Atoms);
    if (!atoms.HasNames)
    {
      return count + (residue.Atoms == 1 ? " atom" : " atoms");
    }
    text += (text.empty() ? "" : "; ") + MakeResidueLabel(atoms.Named[residue.First]) + " (" +
      count + ')';
  }
  return text;
}

const char* SiteClassLabel(int kind)
{
  static const char* const names[] = { "none", "for - proteins", "for - ligands", "for + proteins",
    "for + ligands" };
  return names[kind >= 0 && kind < 5 ? kind : 0];
}

}

std::vector<std::string> FindSiteResidues(const SurfaceView& surface,
  const std::vector<int>& labels, std::size_t sites, const MoleculeAtoms& atoms)
{
  std::vector<Point3> places;
  std::vector<std::size_t> siteOf;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    if (labels[i] > 0)
    {
      places.push_back(surface.Points[i]);
      siteOf.push_back(static_cast<std::size_t>(labels[i]) - 1);
    }
  }
  const PointBins bins(places, SiteReach);
  std::vector<NearResidues> near(sites);
  for (const vtkIdType point : atoms.Points)
  {
    const auto id = static_cast<std::size_t>(point);
    const NamedAtom& atom = atoms.Named[id];
    std::set<std::size_t> found;
    bins.Near(atom.Place, SiteReach,
      [&](std::int64_t place, double) { found.insert(siteOf[static_cast<std::size_t>(place)]); });
    for (const std::size_t site : found)
    {
      const auto [at, isNew] = near[site].try_emplace(
        { atom.Chain, atom.ResidueId, atom.InsertionCode, atom.Residue }, NearResidue{ id });
      ++at->second.Atoms;
    }
  }
  std::vector<std::string> texts;
  texts.reserve(near.size());
  for (const NearResidues& residues : near)
  {
    texts.push_back(JoinResidueNames(residues, atoms));
  }
  return texts;
}

void FillSiteTable(
  const BindingSiteResult& result, const std::vector<std::string>& residues, vtkTable* table)
{
  const std::vector<BindingSite>& sites = result.Sites;
  const auto real = [&](const char* name, double BindingSite::*member)
  {
    AddComputedColumn<vtkDoubleArray>(
      table->GetRowData(), name, sites.size(), [&](std::size_t i) { return sites[i].*member; });
  };
  AddComputedColumn<vtkIntArray>(table->GetRowData(), "Rank", sites.size(),
    [](std::size_t i) { return static_cast<int>(i) + 1; });
  real("Score", &BindingSite::Score);
  AddComputedColumn<vtkIntArray>(table->GetRowData(), "SiteClass", sites.size(),
    [&](std::size_t i) { return int{ sites[i].Kind }; });
  AddComputedColumn<vtkStringArray>(table->GetRowData(), "Class", sites.size(),
    [&](std::size_t i) { return SiteClassLabel(sites[i].Kind); });
  if (!residues.empty())
  {
    AddComputedColumn<vtkStringArray>(
      table->GetRowData(), "Residues", sites.size(), [&](std::size_t i) { return residues[i]; });
  }
  if (std::any_of(
        sites.begin(), sites.end(), [](const BindingSite& site) { return site.Volume > 0.0; }))
  {
    real("Volume", &BindingSite::Volume);
  }
  real("Area", &BindingSite::Area);
  real("MeanDepth", &BindingSite::MeanDepth);
  real("MeanPotential", &BindingSite::MeanPotential);
  const char* const center[] = { "CenterX", "CenterY", "CenterZ" };
  for (std::size_t a = 0; a < 3; ++a)
  {
    AddComputedColumn<vtkDoubleArray>(table->GetRowData(), center[a], sites.size(),
      [&](std::size_t i) { return sites[i].Center[a]; });
  }
  AddComputedColumn<vtkIdTypeArray>(
    table->GetRowData(), "Points", sites.size(), [&](std::size_t i) { return sites[i].Points; });
  AddColumn<vtkDoubleArray>(table->GetFieldData(), "Threshold", { result.Threshold });
}

}
