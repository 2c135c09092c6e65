#include "Molecules/MacromoleculeReader.h"

#include "Core/RangeChecks.h"
#include "Files/OpenByteSource.h"
#include "Files/TextLines.h"
#include "Molecules/AtomSelection.h"
#include "Molecules/BinaryCIF.h"
#include "Molecules/CoordinateUnits.h"
#include "Molecules/CovalentBonds.h"
#include "Molecules/MoleculeParsers.h"
#include "Molecules/PeriodicMolecules.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// As text, or as it is if it is BinaryCIF.
std::unique_ptr<ByteSource> OpenMolecule(const std::string& path)
{
  std::array<char, 1000> begin{};
  const std::size_t size = OpenByteSource(path)->Read(0, begin.data(), begin.size());
  return IsBinaryCIF({ begin.data(), size }) ? OpenByteSource(path) : OpenTextSource(path);
}

Macromolecule Parse(std::string_view text, const std::string& path, MoleculeFormat format,
  const StructureChoice& choice, const ProgressCallback& progress)
{
  if (format == MoleculeFormat::ByName)
  {
    format = FormatFromName(path);
  }
  if (format == MoleculeFormat::ByName)
  {
    format = FormatFromText(text, path);
  }
  const std::string other = DescribeForeignContent(text, format);
  if (!other.empty())
  {
    throw std::runtime_error(path + ": " + other);
  }
  const bool isStructure = format == MoleculeFormat::MMCIF || format == MoleculeFormat::PDB;
  if (!isStructure && !choice.Assembly.empty())
  {
    throw std::runtime_error(
      path + ": only PDB and mmCIF files describe assemblies. Leave Assembly empty.");
  }
  return FindFormat(format).Parse(text, path, choice, progress);
}

void CheckModel(const Macromolecule& molecule, const std::string& path, std::int64_t model)
{
  if (molecule.NumberOfModels > 0 && (model < 0 || model >= molecule.NumberOfModels))
  {
    throw std::runtime_error(path + ": there is no model " + std::to_string(model) +
      ", they are numbered 0 to " + std::to_string(molecule.NumberOfModels - 1) + ".");
  }
  if (molecule.Atoms.empty())
  {
    throw std::runtime_error(path +
      ": there is no atom in it. The file may be truncated, or its name may not match its "
      "content.");
  }
}

/// "3 atoms have ...: FE of HEM 142 A, ..." of those for which `has` holds.
template <typename Predicate>
std::string DescribeAtoms(const Macromolecule& molecule, const char* what, Predicate has)
{
  constexpr int mostNamed = 5;
  int count = 0;
  std::string names;
  for (const Atom& atom : molecule.Atoms)
  {
    if (has(atom))
    {
      names += ++count <= mostNamed ? (count > 1 ? ", " : "") + Describe(atom) : "";
    }
  }
  return std::to_string(count) + (count == 1 ? " atom has " : " atoms have ") + what + ": " +
    names + (count > mostNamed ? ", ..." : "") + ".";
}

bool IsChargedPoint(const Atom& atom)
{
  return atom.Radius == 0.0 && atom.Charge != 0.0;
}

void SetRadii(Macromolecule& molecule, RadiusTable table)
{
  bool noRadius = false, chargedPoint = false, noCharge = false, charge = false;
  for (Atom& atom : molecule.Atoms)
  {
    atom.Radius = std::isnan(atom.Radius) ? VanDerWaalsRadius(atom.Element, table) : atom.Radius;
    noRadius = noRadius || std::isnan(atom.Radius);
    chargedPoint = chargedPoint || IsChargedPoint(atom);
    noCharge = noCharge || std::isnan(atom.Charge);
    charge = charge || !std::isnan(atom.Charge);
  }
  if (noRadius)
  {
    molecule.Warnings.push_back(DescribeAtoms(molecule, "no radius in the table",
      [](const Atom& atom) { return std::isnan(atom.Radius); }));
  }
  if (chargedPoint)
  {
    molecule.Notes.push_back(
      DescribeAtoms(molecule, "the radius 0 in the file, and a charge", IsChargedPoint));
  }
  if (!charge)
  {
    molecule.Notes.emplace_back("The file has no charges; Force Field Charges assigns them.");
  }
  else if (noCharge)
  {
    molecule.Notes.push_back(DescribeAtoms(
      molecule, "no charge in the file", [](const Atom& atom) { return std::isnan(atom.Charge); }));
  }
}

}

void Check(const MoleculeOptions& options)
{
  RequireChoice("Format", options.Format, static_cast<MoleculeFormat>(NumberOfMoleculeFormats));
  RequireChoice("LengthUnit", options.LengthUnit, CoordinateUnit::Bohr);
  RequireChoice("CombineModels", options.CombineModels, ModelCombination::Always);
  RequireChoice("RadiusTable", options.RadiusTable, RadiusTable::Alvarez);
}

Macromolecule ParseMacromolecule(std::string_view text, const std::string& path,
  const MoleculeOptions& options, const ProgressCallback& progress)
{
  Check(options);
  Macromolecule parsed = Parse(text, path, options.Format,
    { options.ModelIndex, options.Assembly, options.CombineModels }, Between(progress, 0.0, 0.6));
  return CompleteMacromolecule(std::move(parsed), path, options, Between(progress, 0.6, 1.0));
}

Macromolecule CompleteMacromolecule(Macromolecule parsed, const std::string& path,
  const MoleculeOptions& options, const ProgressCallback& progress)
{
  Check(options);
  Macromolecule molecule = std::move(parsed);
  CheckModel(molecule, path, options.ModelIndex);
  Report(progress, 0.0);
  ConvertUnit(molecule, options.LengthUnit);
  SelectAtoms(molecule, options);
  const bool mayHaveBonds = CheckDistances(molecule, options.LengthUnit);
  SetRadii(molecule, options.RadiusTable);
  Report(progress, 0.25);
  if (options.BondsByDistance && mayHaveBonds)
  {
    AddCovalentBonds(molecule, Between(progress, 0.25, 1.0));
  }
  else
  {
    SortBonds(molecule);
  }
  if (mayHaveBonds && molecule.MayBeBroken)
  {
    MakeMoleculesWhole(molecule, options.BondsByDistance);
  }
  return molecule;
}

Macromolecule ReadMacromolecule(
  const std::string& path, const MoleculeOptions& options, const ProgressCallback& progress)
{
  Check(options);
  const std::string text = ReadAll(*OpenMolecule(path), Between(progress, 0.0, 0.2));
  return ParseMacromolecule(text, path, options, Between(progress, 0.2, 1.0));
}

std::int64_t CountModels(
  const std::string& path, MoleculeFormat format, Macromolecule* parsed, ModelCombination combine)
{
  Macromolecule molecule =
    Parse(ReadAll(*OpenMolecule(path)), path, format, { 0, {}, combine }, {});
  const std::int64_t models = molecule.NumberOfModels;
  if (parsed)
  {
    *parsed = std::move(molecule);
  }
  return models;
}

bool LooksLikeMolecule(const std::string& path)
{
  if (FormatFromName(path) == MoleculeFormat::ByName)
  {
    return false;
  }
  try
  {
    std::array<char, 4096> begin;
    const std::size_t size = OpenByteSource(path)->Read(0, begin.data(), begin.size());
    if (IsBinaryCIF({ begin.data(), size }))
    {
      return FormatFromName(path) == MoleculeFormat::MMCIF;
    }
    if (BeginsAsUTF16({ begin.data(), size }))
    {
      return true; // the reader's message explains what to do
    }
    return std::find(begin.begin(), begin.begin() + static_cast<std::ptrdiff_t>(size), '\0') ==
      begin.begin() + static_cast<std::ptrdiff_t>(size);
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

}
