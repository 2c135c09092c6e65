// PDBx/mmCIF, BinaryCIF, core CIF and chemical components. gemmi (M. Wojdyr, J. Open Source Softw.
// 7 (2022) 4200) parses the text; atoms come from its tables (CIFAtoms.h). gemmi's own conversion
// of a document to a structure requires columns that predictors, refinement programs and exporters
// do not write, and drops a file for one malformed value.

#include "Core/ParallelFor.h"
#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"
#include "Molecules/BinaryCIF.h"
#include "Molecules/BiologicalAssembly.h"
#include "Molecules/CIFAssemblies.h"
#include "Molecules/CIFAtoms.h"
#include "Molecules/MoleculeParsers.h"
#include "Molecules/ResidueOrder.h"
#include "Molecules/StructureRecords.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <utility>

#include <gemmi/cif.hpp>
#include <gemmi/util.hpp>

namespace isthmus
{
namespace
{

/// Whether a category of BinaryCIF is read.
bool IsWanted(const std::string& category)
{
  const std::string name = gemmi::to_lower(category);
  const std::array<const char*, 11> wanted{ "_atom_site.", "_atom_type", "_cell.",
    "_chem_comp_atom.", "_chem_comp_bond.", "_ma_qa_metric", "_pdbx_struct_", "_struct_conf.",
    "_struct_conn.", "_struct_sheet_range.", "_refln." };
  return std::any_of(wanted.begin(), wanted.end(),
    [&name](const char* with) { return gemmi::starts_with(name, with); });
}

/// A data block with atoms.
struct AtomBlock
{
  gemmi::cif::Block* Block;
  CIFAtoms Atoms;
};

/// "A, B, C, ..."
std::string JoinNames(const std::vector<AtomBlock>& blocks)
{
  constexpr std::size_t mostNamed = 5;
  std::string names;
  for (std::size_t i = 0; i < std::min(blocks.size(), mostNamed); ++i)
  {
    names += (i > 0 ? ", " : "") + blocks[i].Block->name;
  }
  return names + (blocks.size() > mostNamed ? ", ..." : "");
}

/// Whether label_asym_id and label_seq_id are used.
bool NeedsLabels(gemmi::cif::Block& block, const StructureChoice& choice)
{
  const auto has = [&block](const char* tag) { return block.find_values(tag).length() > 0; };
  return !choice.Assembly.empty() || has("_ma_qa_metric_local.metric_value") ||
    (has("_struct_conn.conn_type_id") && !has("_struct_conn.ptnr1_auth_seq_id"));
}

/// The blocks with atoms. Chemical components beside a structure are its dictionary.
std::vector<AtomBlock> FindAtoms(gemmi::cif::Document& document, const StructureChoice& choice)
{
  std::vector<AtomBlock> blocks;
  bool hasReflections = false;
  std::string why; // the first block that can't be read
  for (gemmi::cif::Block& block : document.blocks)
  {
    hasReflections =
      hasReflections || block.has_tag("_refln.index_h") || block.has_tag("_refln_index_h");
    try
    {
      CIFAtoms atoms = ReadCIFAtoms(block, NeedsLabels(block, choice));
      if (atoms.From != CIFAtoms::Source::None)
      {
        blocks.push_back({ &block, std::move(atoms) });
      }
    }
    catch (const std::invalid_argument& error)
    {
      why = why.empty() ? "data block " + block.name + ": " + error.what() : why;
    }
  }
  if (blocks.empty() && !why.empty())
  {
    throw std::invalid_argument(why);
  }
  const auto isComponent = [](const AtomBlock& block)
  { return block.Atoms.From == CIFAtoms::Source::ChemicalComponent; };
  if (!std::all_of(blocks.begin(), blocks.end(), isComponent))
  {
    blocks.erase(std::remove_if(blocks.begin(), blocks.end(), isComponent), blocks.end());
  }
  if (blocks.empty())
  {
    throw std::invalid_argument(hasReflections
        ? "it contains reflections (structure factors) and no atoms; open the coordinate file"
        : "there is no atom in it; no data block has a table with coordinates: _atom_site with "
          "Cartn_x, y, z or "
          "fract_x, y, z, or _chem_comp_atom");
  }
  if (!why.empty())
  {
    blocks[0].Atoms.Report.Warn("Dropped: " + why + ".");
  }
  return blocks;
}

/// Bonds of a chemical component, whose table names atoms.
void AddNamedBonds(CIFAtoms& atoms, Macromolecule& molecule)
{
  // By component and name, and by name alone where the table does not give the component.
  const auto keyOf = [](const std::string& component, const std::string& name)
  { return component + '\n' + name; };
  std::unordered_map<std::string, std::int64_t> place;
  for (std::size_t i = 0; !atoms.Bonded.empty() && i < molecule.Atoms.size(); ++i)
  {
    const Atom& atom = molecule.Atoms[i];
    place.emplace(keyOf(atom.ResidueName, atom.Name), static_cast<std::int64_t>(i));
    place.emplace(keyOf("", atom.Name), static_cast<std::int64_t>(i));
  }
  std::size_t missing = 0;
  for (const auto& [component, one, other] : atoms.Bonded)
  {
    const auto first = place.find(keyOf(component, one));
    const auto second = place.find(keyOf(component, other));
    if (first != place.end() && second != place.end() && first->second != second->second)
    {
      molecule.Bonds.push_back(
        { std::min(first->second, second->second), std::max(first->second, second->second), true });
    }
    else
    {
      ++missing;
    }
  }
  if (missing > 0)
  {
    atoms.Report.Note(
      "Bonds of chem_comp_bond with missing atoms, dropped: " + std::to_string(missing) + ".");
  }
}

/// pLDDT of ModelCIF by model (from 0), label_asym_id and label_seq_id.
using Confidence = std::map<std::tuple<int, std::string, std::string>, double, std::less<>>;

Confidence ReadConfidence(gemmi::cif::Block& block)
{
  Confidence values;
  std::set<std::string> metrics;
  for (auto row : block.find("_ma_qa_metric.", { "id", "name" }))
  {
    if (gemmi::to_lower(row.str(1)) == "plddt")
    {
      metrics.insert(row.str(0));
    }
  }
  std::map<std::string, int> models; // numbered in the order in which they come
  for (auto row : block.find("_ma_qa_metric_local.",
         { "metric_id", "label_asym_id", "label_seq_id", "metric_value", "?model_id" }))
  {
    const double value = CIFNumber(row[3]);
    if (metrics.count(row.str(0)) > 0 && !std::isnan(value))
    {
      const std::string model = row.has(4) ? row.str(4) : std::string();
      const int number = models.emplace(model, static_cast<int>(models.size())).first->second;
      values[{ number, row.str(1), row.str(2) }] = value;
    }
  }
  return values;
}

/// The atoms of one model of a block, those of a residue together.
struct CIFModel
{
  Macromolecule Molecule;
  std::vector<std::array<std::string_view, 2>> Labels;
  std::vector<bool> IsDummy;
  std::vector<std::size_t> Residues; ///< first atoms
};

/// Brings the atoms of residues together. The first one of a residue says whether it is a hetero
/// group.
void OrderResidues(CIFModel& model)
{
  std::vector<Atom>& atoms = model.Molecule.Atoms;
  std::vector<ResidueRun> runs;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const bool isChain = i == 0 || atoms[i].Chain != atoms[i - 1].Chain;
    if (isChain || atoms[i].ResidueId != atoms[i - 1].ResidueId ||
      atoms[i].InsertionCode != atoms[i - 1].InsertionCode ||
      atoms[i].ResidueName != atoms[i - 1].ResidueName)
    {
      const std::size_t group = runs.empty() ? 0 : runs.back().Group + (isChain ? 1 : 0);
      runs.push_back({ i, i, group, atoms[i].ResidueId, atoms[i].ResidueName,
        static_cast<char>(atoms[i].InsertionCode | 0x20) });
    }
    runs.back().Last = i + 1;
  }
  ResidueOrder order = FindResidueOrder(runs);
  if (!order.IsOfFile)
  {
    std::vector<std::size_t> from(atoms.size());
    for (std::size_t r = 0; r < runs.size(); ++r)
    {
      for (std::size_t i = runs[r].First; i < runs[r].Last; ++i)
      {
        from[order.Place[r] + i - runs[r].First] = i;
      }
    }
    Reorder(atoms, from);
    Reorder(model.Labels, from);
    Reorder(model.IsDummy, from);
  }
  model.Residues = std::move(order.Starts);
  for (std::size_t r = 0, i = 0; i < atoms.size(); ++i)
  {
    r += r + 1 < model.Residues.size() && model.Residues[r + 1] == i ? 1 : 0;
    atoms[i].IsHetero = atoms[model.Residues[r]].IsHetero;
  }
}

CIFModel TakeModel(CIFAtoms& atoms, int wanted)
{
  CIFModel model;
  model.Molecule.Atoms = std::move(atoms.Atoms);
  model.Labels = std::move(atoms.Labels);
  model.IsDummy = std::move(atoms.IsDummy);
  if (!atoms.Model.empty())
  {
    std::vector<std::size_t> from;
    for (std::size_t i = 0; i < atoms.Model.size(); ++i)
    {
      if (atoms.Model[i] == wanted)
      {
        from.push_back(i);
      }
    }
    Reorder(model.Molecule.Atoms, from);
    Reorder(model.Labels, from);
    Reorder(model.IsDummy, from);
  }
  OrderResidues(model);
  return model;
}

/// The residues of a model, by the authors' chains and numbers or by the other ones.
class ConnectionEnds
{
public:
  ConnectionEnds(const CIFModel& model, bool byLabels)
    : Atoms(model.Molecule.Atoms)
  {
    for (std::size_t r = 0; r < model.Residues.size(); ++r)
    {
      const std::size_t first = model.Residues[r];
      const std::size_t last =
        r + 1 < model.Residues.size() ? model.Residues[r + 1] : this->Atoms.size();
      const Atom& atom = this->Atoms[first];
      int number = 0;
      if (!byLabels)
      {
        this->Residues.Add(
          0, atom.Chain, atom.ResidueName, atom.ResidueId, atom.InsertionCode, first, last);
      }
      else if (IsNumber(model.Labels[first][1], number))
      {
        this->Residues.Add(0, model.Labels[first][0], atom.ResidueName, number, ' ', first, last);
      }
    }
  }

  std::optional<std::size_t> Find(gemmi::cif::Table::Row& row, int partner) const
  {
    const auto text = [&](int column)
    {
      const auto at = static_cast<std::size_t>(2 * column + partner);
      return row.has(at) ? CIFText(row[static_cast<int>(at)]) : std::string_view();
    };
    int number = 0;
    if (!IsNumber(text(1), number))
    {
      return {};
    }
    const auto letter = [](std::string_view value) { return value.empty() ? ' ' : value[0]; };
    return FindAtom(this->Atoms, this->Residues.Find(0, text(0), text(2), number, letter(text(4))),
      text(3), letter(text(5)));
  }

private:
  const std::vector<Atom>& Atoms;
  ResidueIndex Residues;
};

/// Bonds of struct_conn, without hydrogen bonds and those to symmetry mates.
void AddConnections(gemmi::cif::Block& block, CIFModel& model, ReadingReport& report)
{
  if (block.find_values("_struct_conn.conn_type_id").length() == 0)
  {
    return;
  }
  const bool byLabels = block.find_values("_struct_conn.ptnr1_auth_seq_id").length() == 0;
  std::vector<std::string> tags;
  for (const char* tag : byLabels
      ? std::array{ "ptnr#_label_asym_id", "ptnr#_label_seq_id", "ptnr#_label_comp_id",
          "ptnr#_label_atom_id", "?pdbx_ptnr#_no_code", "?pdbx_ptnr#_label_alt_id",
          "?ptnr#_symmetry" }
      : std::array{ "ptnr#_auth_asym_id", "ptnr#_auth_seq_id", "ptnr#_label_comp_id",
          "ptnr#_label_atom_id", "?pdbx_ptnr#_PDB_ins_code", "?pdbx_ptnr#_label_alt_id",
          "?ptnr#_symmetry" })
  {
    for (const char partner : { '1', '2' })
    {
      tags.emplace_back(tag);
      std::replace(tags.back().begin(), tags.back().end(), '#', partner);
    }
  }
  const auto typeAt = tags.size();
  tags.emplace_back("conn_type_id");
  gemmi::cif::Table table = block.find("_struct_conn.", tags);
  if (!table.ok())
  {
    report.Warn(
      "The table of connections (struct_conn) lacks chains, numbers or names of atoms and was "
      "dropped; bonds are found by distance.");
    return;
  }
  const ConnectionEnds ends(model, byLabels);
  std::size_t missing = 0;
  for (gemmi::cif::Table::Row row : table)
  {
    const auto symmetry = [&](int partner)
    { return row.has2(typeAt - 2 + static_cast<std::size_t>(partner)); };
    const bool isMate = symmetry(0) && symmetry(1) &&
      row.str(static_cast<int>(typeAt) - 2) != row.str(static_cast<int>(typeAt) - 1);
    if (isMate || row.str(static_cast<int>(typeAt)) == "hydrog")
    {
      continue;
    }
    const auto first = ends.Find(row, 0);
    const auto second = ends.Find(row, 1);
    missing += first && second ? 0 : 1;
    if (first && second && *first != *second)
    {
      model.Molecule.Bonds.push_back({ static_cast<std::int64_t>(std::min(*first, *second)),
        static_cast<std::int64_t>(std::max(*first, *second)), true });
    }
  }
  if (missing > 0)
  {
    report.Note("Bonds of struct_conn with atoms that are not in this model, dropped: " +
      std::to_string(missing) + ".");
  }
}

void SetConfidence(gemmi::cif::Block& block, int wanted, CIFModel& model)
{
  const Confidence values = ReadConfidence(block);
  for (std::size_t i = 0; i < model.Labels.size() && !values.empty(); ++i)
  {
    const auto found = values.find(std::tuple(wanted, model.Labels[i][0], model.Labels[i][1]));
    if (found != values.end())
    {
      model.Molecule.Atoms[i].PLDDT = found->second;
    }
  }
}

/// The assembly of a model that the block describes.
Macromolecule TakeAssembly(
  gemmi::cif::Block& block, const CIFModel& model, const std::string& name, const std::string& path)
{
  try
  {
    std::vector<gemmi::Assembly> known;
    for (const std::string& one : CIFAssemblyNames(block))
    {
      known.push_back(one == name ? ReadCIFAssembly(block, name) : gemmi::Assembly(one));
    }
    return BuildAssembly(model.Molecule, FindAssembly(name, known, path), path,
      [&model](std::size_t atom) { return std::string(model.Labels[atom][0]); });
  }
  catch (const std::invalid_argument& error)
  {
    throw UnknownAssembly(path + ": " + error.what() + ".");
  }
}

/// One model of a block.
Macromolecule ReadModel(
  AtomBlock& block, int wanted, const std::string& path, const std::string& assembly)
{
  ReadingReport& report = block.Atoms.Report;
  const bool isMacromolecule = block.Atoms.From == CIFAtoms::Source::MMCIF;
  CIFModel model = TakeModel(block.Atoms, wanted);
  Macromolecule& molecule = model.Molecule;
  AddConnections(*block.Block, model, report);
  AddNamedBonds(block.Atoms, molecule);
  SetConfidence(*block.Block, wanted, model);
  if (isMacromolecule)
  {
    SetElements(molecule.Atoms, report, ElementColumn::Table, model.IsDummy);
  }
  else
  {
    ReportMissingElements(molecule.Atoms, report);
  }
  if (!assembly.empty())
  {
    return TakeAssembly(*block.Block, model, assembly, path);
  }
  SetStructure(ReadCIFStructure(*block.Block), molecule.Atoms);
  molecule.Cell = ReadCIFCell(*block.Block);
  molecule.SpaceGroup = ReadCIFSpaceGroup(*block.Block);
  molecule.MayBeBroken = isMacromolecule; // crystals of small molecules are not simulated
  return std::move(molecule);
}

/// The chosen model. Models are counted through all blocks with atoms.
Macromolecule ReadBlocks(
  gemmi::cif::Document& document, const std::string& path, const StructureChoice& choice)
{
  std::vector<AtomBlock> blocks = FindAtoms(document, choice);
  Macromolecule molecule;
  ReadingReport report;
  std::int64_t models = 0;
  for (AtomBlock& block : blocks)
  {
    if (choice.Model >= models && choice.Model < models + block.Atoms.NumberOfModels)
    {
      molecule = ReadModel(block, static_cast<int>(choice.Model - models), path, choice.Assembly);
      report = std::move(block.Atoms.Report);
    }
    models += block.Atoms.NumberOfModels;
  }
  molecule.NumberOfModels = models;
  if (blocks.size() > 1)
  {
    report.Warn("The file has " + std::to_string(blocks.size()) + " data blocks with atoms (" +
      JoinNames(blocks) + "), which are its models 0 to " + std::to_string(models - 1) +
      "; this is model " + std::to_string(choice.Model) + ".");
  }
  report.AddTo(molecule);
  return molecule;
}

}

/// Or BinaryCIF.
bool IsMMCIF(std::string_view text)
{
  return IsBinaryCIF(text) || text.substr(0, 5) == "data_" ||
    text.find("\ndata_") != std::string_view::npos;
}

Macromolecule ParseMMCIF(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress)
{
  Macromolecule molecule;
  try
  {
    gemmi::cif::Document document = IsBinaryCIF(text)
      ? ReadBinaryCIF(text, IsWanted)
      : gemmi::cif::read_memory(text.data(), text.size(), path.c_str());
    Report(progress, 0.5);
    molecule = ReadBlocks(document, path, choice);
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const UnknownAssembly&)
  {
    throw;
  }
  catch (const std::invalid_argument& error)
  {
    throw std::runtime_error(path + ": this can't be read as " +
      (IsBinaryCIF(text) ? "BinaryCIF: " : "mmCIF or core CIF: ") + error.what() + ".");
  }
  catch (const std::exception& error)
  {
    std::string reason = error.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw std::runtime_error(path + ": this can't be read as mmCIF (" + reason +
      "). The file may be truncated, or its name may not match its content.");
  }
  for (const Atom& atom : molecule.Atoms)
  {
    if (!std::isfinite(atom.Position[0] + atom.Position[1] + atom.Position[2]))
    {
      throw std::runtime_error(path + ": a coordinate of " + Describe(atom) +
        " is not a finite number. The file may be truncated.");
    }
  }
  return molecule;
}

}
