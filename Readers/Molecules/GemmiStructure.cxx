#include "Molecules/GemmiStructure.h"

#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Files/TextLines.h"
#include "Molecules/AtomElements.h"
#include "Molecules/BinaryCIF.h"
#include "Molecules/CIFAssemblies.h"
#include "Molecules/CIFAtomTable.h"
#include "Molecules/GemmiAtom.h"
#include "Molecules/PDBColumns.h"
#include "Molecules/PDBFile.h"
#include "Molecules/PDBLines.h"
#include "Molecules/PQRFile.h"
#include "Molecules/PeriodicMolecules.h"
#include "Molecules/ReadingReport.h"
#include "Molecules/StructureRecords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include <gemmi/assembly.hpp>
#include <gemmi/atox.hpp>
#include <gemmi/cif.hpp>
#include <gemmi/cifdoc.hpp>
#include <gemmi/mmcif.hpp>
#include <gemmi/pdb.hpp>
#include <gemmi/util.hpp>

namespace isthmus
{
namespace
{

/// The file is valid, but does not describe the requested assembly.
class UnknownAssembly : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void RefuseAssembly(
  const std::string& name, const std::vector<std::string>& known, const std::string& path)
{
  std::string list;
  for (const std::string& one : known)
  {
    list += (list.empty() ? "" : ", ") + one;
  }
  throw UnknownAssembly(path + ": there is no assembly " + name + "; the file describes " +
    (list.empty() ? "none." : list + "."));
}

/// The box around the copies of the box around all atoms.
gemmi::Box<gemmi::Position> ComputeBox(
  const gemmi::Structure& structure, const gemmi::Assembly& assembly)
{
  gemmi::Box<gemmi::Position> atoms;
  for (const gemmi::Model& model : structure.models)
  {
    for (const gemmi::const_CRA& cra : model.all())
    {
      atoms.extend(cra.atom->pos);
    }
  }
  gemmi::Box<gemmi::Position> box;
  for (const gemmi::Assembly::Gen& generator : assembly.generators)
  {
    for (const gemmi::Assembly::Operator& copy : generator.operators)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        box.extend(gemmi::Position(
          copy.transform.apply(gemmi::Vec3(corner % 2 == 0 ? atoms.minimum.x : atoms.maximum.x,
            corner / 2 % 2 == 0 ? atoms.minimum.y : atoms.maximum.y,
            corner / 4 == 0 ? atoms.minimum.z : atoms.maximum.z))));
      }
    }
  }
  return box;
}

/**
 * gemmi looks for atoms on symmetry axes with a grid of 4 angstrom around all copies, whose size it
 * does not check.
 * @throws UnknownAssembly where the copies are too far apart for it.
 */
void RequireModestBox(
  const gemmi::Structure& structure, const gemmi::Assembly& assembly, const std::string& path)
{
  constexpr double spacing = 4.0;
  constexpr double mostCells = 2e8;
  const gemmi::Position size = ComputeBox(structure, assembly).get_size();
  const auto cells = [](double length) { return std::max(length / spacing, 1.0); };
  const bool hasNone = !(size.x >= 0.0); // no atoms, or no operators
  if (hasNone || cells(size.x) * cells(size.y) * cells(size.z) < mostCells)
  {
    return;
  }
  throw UnknownAssembly(
    JoinText(path, ": assembly ", assembly.name, " is ", size.x, " x ", size.y, " x ", size.z,
      " angstrom large, which is too large to search. Correct its operators or leave Assembly "
      "empty."));
}

/**
 * Replaces the models of `structure` by assembly `name` as the file describes it (REMARK 350 of
 * PDB, pdbx_struct_assembly_gen of mmCIF): each chain once for each of its operators, copies under
 * names that are free. Atoms on symmetry axes stay single. @throws UnknownAssembly.
 */
void TakeAssembly(gemmi::Structure& structure, const std::string& name, const std::string& path)
{
  const gemmi::Assembly* const wanted = structure.find_assembly(name);
  if (!wanted)
  {
    std::vector<std::string> known;
    for (const gemmi::Assembly& assembly : structure.assemblies)
    {
      known.push_back(assembly.name);
    }
    RefuseAssembly(name, known, path);
  }
  RequireModestBox(structure, *wanted, path);
  gemmi::transform_to_assembly(structure, name, gemmi::HowToNameCopiedChain::Short, {});
}

/// Categories of an mmCIF file that gemmi makes atoms and bonds of.
const std::vector<std::string> CategoriesRead{ "_atom_site.", "_atom_site_", "_atom_sites.",
  "_atom_type", "_cell.", "_cell_", "_chem_comp_atom.", "_chem_comp_bond.", "_symmetry.",
  "_entity.", "_entity_poly.", "_ma_qa_metric", "_struct_asym.", "_struct_conn." };

/// The categories among them that are not needed for atoms.
const std::vector<std::string> CategoriesOfAtoms{ "_atom_site." };

bool IsOfCategory(const gemmi::cif::Item& item, const std::vector<std::string>& categories)
{
  using gemmi::cif::ItemType;
  const bool isLoop = item.type == ItemType::Loop && !item.loop.tags.empty();
  if (!isLoop && item.type != ItemType::Pair)
  {
    return false;
  }
  const std::string tag = gemmi::to_lower(isLoop ? item.loop.tags.front() : item.pair[0]);
  return std::any_of(categories.begin(), categories.end(),
    [&tag](const std::string& category) { return gemmi::starts_with(tag, category); });
}

/// Whether a category of BinaryCIF is read.
bool IsWanted(const std::string& category)
{
  const std::string name = gemmi::to_lower(category);
  const auto begins = [&name](const std::string& with) { return gemmi::starts_with(name, with); };
  return std::any_of(CategoriesRead.begin(), CategoriesRead.end(), begins) ||
    begins("_pdbx_struct_assembly_gen.") || begins("_pdbx_struct_oper_list.") ||
    begins("_struct_conf.") || begins("_struct_sheet_range.") || begins("_refln.");
}

void DropOthers(gemmi::cif::Block& block, const std::vector<std::string>& categories)
{
  const auto isOther = [&categories](const gemmi::cif::Item& item)
  { return !IsOfCategory(item, categories); };
  block.items.erase(
    std::remove_if(block.items.begin(), block.items.end(), isOther), block.items.end());
}

/// Calls `work(value)` for each value of a column, several at once; none where it is missing.
template <typename Work>
void ForEachValue(gemmi::cif::Block& block, const std::string& tag, Work&& work)
{
  constexpr std::int64_t valuesAtOnce = 1 << 12;
  gemmi::cif::Column column = block.find_values(tag);
  ParallelFor(0, column.length(), valuesAtOnce,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t i = first; i < last; ++i)
      {
        work(column[static_cast<int>(i)]);
      }
    });
}

void RequireShortNumbers(gemmi::cif::Block& block, const std::string& tag, std::size_t most)
{
  ForEachValue(block, tag,
    [&](const std::string& value)
    {
      std::size_t digits = 0;
      for (const char c : value)
      {
        digits = gemmi::is_digit(c) ? digits + 1 : 0;
        if (digits > most)
        {
          throw std::invalid_argument(
            tag + " has a number of more than " + std::to_string(most) + " digits");
        }
      }
    });
}

/// Gives unknown values of a column a number by which they are found again.
void MarkBlanks(gemmi::cif::Block& block, const char* tag)
{
  ForEachValue(block, tag,
    [](std::string& value)
    {
      if (gemmi::cif::is_null(value))
      {
        value = BlankText;
      }
    });
}

/**
 * Reduces a block to the categories that describe atoms, bonds and assemblies: gemmi reads all
 * categories it supports, and an error in another one would discard the atoms. Completes the table
 * of atoms. Unknown occupancies and B factors become BlankText, by which they are found again.
 * O(values).
 *
 * @throws std::invalid_argument for whole numbers of more than nine digits: gemmi (0.5.7) adds
 * digits up without a look at their size.
 */
CIFAtoms PrepareForGemmi(gemmi::cif::Block& block)
{
  std::vector<StructureRange> structure = ReadCIFStructure(block);
  DropOthers(block, CategoriesRead);
  CIFAtoms atoms = CompleteAtomTable(block);
  atoms.Structure = std::move(structure);
  for (const char* tag : { "_atom_site.id", "_atom_site.auth_seq_id", "_atom_site.label_seq_id",
         "_atom_site.pdbx_formal_charge", "_struct_conn.ptnr1_auth_seq_id",
         "_struct_conn.ptnr2_auth_seq_id", "_struct_conn.ptnr1_label_seq_id",
         "_struct_conn.ptnr2_label_seq_id" })
  {
    RequireShortNumbers(block, tag, 9);
  }
  MarkBlanks(block, "_atom_site.occupancy");
  MarkBlanks(block, "_atom_site.B_iso_or_equiv");
  return atoms;
}

[[noreturn]] void Fail(const std::string& path, const char* format, const std::exception& error)
{
  std::string reason = error.what();
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  throw std::runtime_error(path + ": this can't be read as " + format + " (" + reason +
    "). The file may be truncated, or its name may not match its content.");
}

void AddBond(Macromolecule& molecule, std::int64_t a, std::int64_t b)
{
  if (a != b)
  {
    molecule.Bonds.push_back({ std::min(a, b), std::max(a, b), true });
  }
}

std::size_t CountAtoms(const gemmi::Model& model)
{
  std::size_t count = 0;
  for (const gemmi::Chain& chain : model.chains)
  {
    for (const gemmi::Residue& residue : chain.residues)
    {
      count += residue.atoms.size();
    }
  }
  return count;
}

/// pLDDT by model, label_asym_id and label_seq_id.
using Confidence = decltype(CIFAtoms::Confidence);

double GetConfidence(const Confidence& values, std::int64_t model, const gemmi::Residue& residue)
{
  if (values.empty())
  {
    return Atom::Unknown;
  }
  const std::string number =
    residue.label_seq.has_value() ? std::to_string(*residue.label_seq) : std::string();
  const auto found = values.find({ model, residue.subchain, number });
  return found == values.end() ? Atom::Unknown : found->second;
}

/// Copies one model and the connections that gemmi has found.
Macromolecule Flatten(const gemmi::Structure& structure, std::int64_t wanted, ReadingReport& report,
  const Confidence& confidence = Confidence())
{
  Macromolecule molecule;
  molecule.NumberOfModels = static_cast<std::int64_t>(structure.models.size());
  if (wanted < 0 || wanted >= molecule.NumberOfModels)
  {
    return molecule;
  }
  const gemmi::Model& model = structure.models[static_cast<std::size_t>(wanted)];
  molecule.Atoms.reserve(CountAtoms(model));
  std::unordered_map<const gemmi::Atom*, std::int64_t> place;
  for (const gemmi::Chain& chain : model.chains)
  {
    for (const gemmi::Residue& residue : chain.residues)
    {
      const double plddt = GetConfidence(confidence, wanted, residue);
      for (const gemmi::Atom& atom : residue.atoms)
      {
        if (!structure.connections.empty())
        {
          place.emplace(&atom, static_cast<std::int64_t>(molecule.Atoms.size()));
        }
        molecule.Atoms.emplace_back();
        Assign(molecule.Atoms.back(), chain, residue, atom);
        molecule.Atoms.back().PLDDT = plddt;
      }
    }
  }
  std::size_t missing = 0;
  for (const gemmi::Connection& connection : structure.connections)
  {
    if (connection.type == gemmi::Connection::Hydrog || connection.asu == gemmi::Asu::Different)
    {
      continue;
    }
    const auto first = place.find(model.find_cra(connection.partner1, true).atom);
    const auto second = place.find(model.find_cra(connection.partner2, true).atom);
    if (first != place.end() && second != place.end())
    {
      AddBond(molecule, first->second, second->second);
    }
    else
    {
      ++missing;
    }
  }
  if (missing > 0)
  {
    report.Note("Bonds of struct_conn with atoms that are not in this model, dropped: " +
      std::to_string(missing) + ".");
  }
  return molecule;
}

/// Checks for abort only, without reporting progress.
ProgressCallback AbortOnly(const ProgressCallback& progress)
{
  return progress ? [progress](double) { return progress(0.6); } : ProgressCallback();
}

/// REMARK 350, which describes assemblies.
std::string RemarksOnAssemblies(std::string_view text)
{
  std::string remarks;
  TextLines lines(text, {}, {});
  for (std::string_view line; lines.Next(line);)
  {
    if (line.substr(0, 10) == "REMARK 350")
    {
      remarks.append(line).append("\n");
    }
  }
  return remarks;
}

gemmi::Atom ToGemmiAtom(const Atom& from)
{
  gemmi::Atom atom;
  atom.name = from.Name;
  atom.altloc = from.AltLoc == ' ' ? '\0' : from.AltLoc;
  atom.element = gemmi::Element(from.Element);
  atom.charge = static_cast<signed char>(std::isnan(from.Charge) ? 0.0 : from.Charge);
  atom.serial = from.Serial;
  atom.pos = gemmi::Position(from.Position[0], from.Position[1], from.Position[2]);
  atom.occ = std::isnan(from.Occupancy) ? BlankNumber : static_cast<float>(from.Occupancy);
  atom.b_iso = std::isnan(from.BFactor) ? BlankNumber : static_cast<float>(from.BFactor);
  return atom;
}

gemmi::ResidueId ToResidueId(const Atom& atom)
{
  gemmi::ResidueId id;
  id.seqid.num = atom.ResidueId;
  id.seqid.icode = atom.InsertionCode;
  id.name = atom.ResidueName;
  return id;
}

/// gemmi's model of atoms that were read, for its assemblies.
void FillModel(const PDBMolecule& molecule, gemmi::Model& model)
{
  for (std::size_t r = 0; r < molecule.Residues.size(); ++r)
  {
    const std::size_t first = molecule.Residues[r];
    const std::size_t last =
      r + 1 < molecule.Residues.size() ? molecule.Residues[r + 1] : molecule.Atoms.size();
    const Atom& atom = molecule.Atoms[first];
    if (model.chains.empty() || model.chains.back().name != atom.Chain)
    {
      model.chains.emplace_back(atom.Chain);
    }
    model.chains.back().residues.emplace_back(ToResidueId(atom));
    gemmi::Residue& residue = model.chains.back().residues.back();
    residue.het_flag = atom.IsHetero ? 'H' : 'A';
    for (std::size_t i = first; i < last; ++i)
    {
      residue.atoms.push_back(ToGemmiAtom(molecule.Atoms[i]));
    }
  }
}

gemmi::AtomAddress ToAtomAddress(const Atom& atom)
{
  gemmi::AtomAddress address;
  address.chain_name = atom.Chain;
  address.res_id = ToResidueId(atom);
  address.atom_name = atom.Name;
  address.altloc = atom.AltLoc == ' ' ? '\0' : atom.AltLoc;
  return address;
}

/// An assembly of a model. CONECT records name atoms of the file: in copies, bonds are found by
/// distance.
Macromolecule BuildAssembly(const PDBMolecule& molecule, const std::string& name,
  std::string_view text, const std::string& path)
{
  const std::string remarks = RemarksOnAssemblies(text);
  gemmi::Structure structure = gemmi::read_pdb_from_memory(remarks.data(), remarks.size(), path);
  FillModel(molecule, structure.models.at(0));
  for (const Bond& bond : molecule.Links)
  {
    gemmi::Connection connection;
    connection.type = gemmi::Connection::Covale;
    connection.asu = gemmi::Asu::Same;
    connection.partner1 = ToAtomAddress(molecule.Atoms[static_cast<std::size_t>(bond.First)]);
    connection.partner2 = ToAtomAddress(molecule.Atoms[static_cast<std::size_t>(bond.Second)]);
    structure.connections.push_back(connection);
  }
  TakeAssembly(structure, name, path);
  ReadingReport ofCopies; // their bonds are those of the file
  return Flatten(structure, 0, ofCopies);
}

Macromolecule ReadColumns(std::string_view text, const std::string& path,
  const StructureChoice& choice, std::size_t bytesOfAPiece, const ProgressCallback& progress)
{
  const PDBLines lines = SplitPDB(text, bytesOfAPiece, Between(progress, 0.0, 0.3));
  ReadingReport report;
  const std::vector<PDBModel> models = FindModels(lines, report, PDBColumnsOfAtoms, choice.Combine);
  const bool isOfCopies = AreCombined(lines, models);
  Macromolecule molecule;
  molecule.NumberOfModels = static_cast<std::int64_t>(models.size());
  if (choice.Model < 0 || choice.Model >= molecule.NumberOfModels)
  {
    return molecule;
  }
  PDBMolecule read = ReadPDBModel(text, path, lines, models[static_cast<std::size_t>(choice.Model)],
    isOfCopies, report, Between(progress, 0.3, 1.0));
  if (EndsWithinRecord(text, lines))
  {
    throw std::runtime_error(path + ", " + FormatLineNumber(text, UnfinishedLine(text)) +
      ": the file ends within this record. Fetch or write it again.");
  }
  if (choice.Assembly.empty())
  {
    molecule.Atoms = std::move(read.Atoms);
    molecule.Bonds = std::move(read.Links);
    molecule.Bonds.insert(molecule.Bonds.end(), read.Bonds.begin(), read.Bonds.end());
    if (!isOfCopies) // whose chains have other names, and are beside the cell
    {
      SetStructure(ReadPDBStructure(text), molecule.Atoms);
      molecule.Cell = FindCell(lines, models[static_cast<std::size_t>(choice.Model)]);
    }
  }
  else
  {
    Macromolecule assembly = BuildAssembly(read, choice.Assembly, text, path);
    molecule.Atoms = std::move(assembly.Atoms);
    molecule.Bonds = std::move(assembly.Bonds);
  }
  report.AddTo(molecule);
  return molecule;
}

/// Some programs, APBS among them, separate the values by blanks regardless of the columns.
Macromolecule ReadPDBByWords(std::string_view text, const std::string& path, std::int64_t model,
  const NonstandardColumnsError& first, const ProgressCallback& progress)
{
  Macromolecule molecule;
  try
  {
    molecule = ParsePQR(text, path, model, progress);
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::runtime_error&)
  {
    throw first;
  }
  if (molecule.NumberOfModels == 0) // records in small letters
  {
    throw first;
  }
  for (Atom& atom : molecule.Atoms)
  {
    atom.Occupancy = std::exchange(atom.Charge, Atom::Unknown);
    atom.BFactor = std::exchange(atom.Radius, Atom::Unknown);
  }
  molecule.Warnings.emplace_back(
    "The values are not in the columns of a PDB file; they were separated at blanks.");
  return molecule;
}

}

Macromolecule ParsePDB(std::string_view text, const std::string& path,
  const StructureChoice& choice, const ProgressCallback& progress, std::size_t bytesOfAPiece)
{
  if (gemmi::starts_with(std::string(text.substr(0, 5)), "data_") || text.substr(0, 4) == "{\"da")
  {
    throw std::runtime_error(path +
      ": this is mmCIF or mmJSON, not PDB. Name it .cif or choose its format (mmJSON: gemmi "
      "convert).");
  }
  try
  {
    return ReadColumns(text, path, choice, bytesOfAPiece, progress);
  }
  catch (const NonstandardColumnsError& error)
  {
    if (!choice.Assembly.empty())
    {
      throw UnknownAssembly(path +
        ": the values are not in the columns of a PDB file, so its assemblies can't be read. Leave "
        "Assembly empty.");
    }
    // Without a progress that restarts from 0, which would not be monotone.
    return ReadPDBByWords(text, path, choice.Model, error, AbortOnly(progress));
  }
}

std::int64_t CountPDBModels(std::string_view text, ModelCombination combine)
{
  ReadingReport report;
  constexpr std::size_t bytesOfAPiece = std::size_t{ 1 } << 20;
  const PDBLines lines = SplitPDB(text, bytesOfAPiece, {});
  const std::size_t models = FindModels(lines, report, PDBColumnsOfAtoms, combine).size();
  return std::max<std::int64_t>(static_cast<std::int64_t>(models), 1);
}

namespace
{

/// A data block with atoms.
struct AtomBlock
{
  gemmi::cif::Block* Block;
  gemmi::cif::Block Assemblies; ///< its categories of assemblies
  CIFAtoms Atoms;
};

/// Moves the categories of assemblies out of a block: gemmi reads their usual forms only.
gemmi::cif::Block MoveAssemblies(gemmi::cif::Block& block)
{
  gemmi::cif::Block assemblies(block.name);
  const auto isOther = [](const gemmi::cif::Item& item) {
    return !IsOfCategory(item, { "_pdbx_struct_assembly_gen.", "_pdbx_struct_oper_list." });
  };
  const auto found = std::stable_partition(block.items.begin(), block.items.end(), isOther);
  std::move(found, block.items.end(), std::back_inserter(assemblies.items));
  block.items.erase(found, block.items.end());
  return assemblies;
}

/// Replaces the models of `structure` by an assembly that the block describes.
void TakeAssembly(gemmi::Structure& structure, gemmi::cif::Block& block, const std::string& name,
  const std::string& path)
{
  const std::vector<std::string> known = CIFAssemblyNames(block);
  if (std::find(known.begin(), known.end(), name) == known.end())
  {
    RefuseAssembly(name, known, path);
  }
  try
  {
    structure.assemblies = { ReadCIFAssembly(block, name) };
  }
  catch (const std::invalid_argument& error)
  {
    throw UnknownAssembly(path + ": " + error.what() + ".");
  }
  TakeAssembly(structure, name, path);
}

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

/// The blocks with atoms. Chemical components beside a structure are its dictionary.
std::vector<AtomBlock> FindAtoms(gemmi::cif::Document& document)
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
      gemmi::cif::Block assemblies = MoveAssemblies(block);
      CIFAtoms atoms = PrepareForGemmi(block);
      if (atoms.From != CIFAtoms::Source::None)
      {
        blocks.push_back({ &block, std::move(assemblies), std::move(atoms) });
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

/// The structure of a block; if a table beside the atoms is at fault, the atoms alone.
gemmi::Structure BuildStructure(AtomBlock& block, bool needsAssembly)
{
  try
  {
    return gemmi::make_structure_from_block(*block.Block);
  }
  catch (const std::exception& error)
  {
    if (needsAssembly)
    {
      throw;
    }
    DropOthers(*block.Block, CategoriesOfAtoms);
    gemmi::Structure structure = gemmi::make_structure_from_block(*block.Block);
    block.Atoms.Report.Warn(
      std::string("The tables beside the atoms (struct_conn, assemblies) can't be read (") +
      error.what() + ") and were dropped; bonds are found by distance.");
    return structure;
  }
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
    if (first != place.end() && second != place.end())
    {
      AddBond(molecule, first->second, second->second);
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

/// The chosen model. Models are counted through all blocks with atoms.
Macromolecule ReadBlocks(
  gemmi::cif::Document& document, const std::string& path, const StructureChoice& choice)
{
  std::vector<AtomBlock> blocks = FindAtoms(document);
  Macromolecule molecule;
  ReadingReport report;
  std::int64_t models = 0;
  for (AtomBlock& block : blocks)
  {
    gemmi::Structure structure = BuildStructure(block, !choice.Assembly.empty());
    block.Block->items.clear(); // 32 bytes for each value
    const auto own = static_cast<std::int64_t>(structure.models.size());
    if (choice.Model >= models && choice.Model < models + own)
    {
      if (!choice.Assembly.empty())
      {
        TakeAssembly(structure, block.Assemblies, choice.Assembly, path);
      }
      molecule =
        Flatten(structure, choice.Model - models, block.Atoms.Report, block.Atoms.Confidence);
      if (choice.Assembly.empty())
      {
        SetStructure(block.Atoms.Structure, molecule.Atoms);
        const gemmi::UnitCell& cell = structure.cell;
        molecule.Cell =
          CellVectors({ cell.a, cell.b, cell.c }, { cell.alpha, cell.beta, cell.gamma });
      }
      AddNamedBonds(block.Atoms, molecule);
      if (block.Atoms.From == CIFAtoms::Source::MMCIF)
      {
        SetElements(molecule.Atoms, block.Atoms.Report, ElementColumn::Table,
          [&block](const Atom& atom) { return block.Atoms.Dummies.count(atom.Serial) > 0; });
      }
      else
      {
        ReportMissingElements(molecule.Atoms, block.Atoms.Report);
      }
      report = std::move(block.Atoms.Report);
    }
    models += own;
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
    Fail(path, "mmCIF", error);
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
