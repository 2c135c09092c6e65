#include "MacromoleculeReader.h"

#include "AtomSelection.h"
#include "CovalentBonds.h"
#include "GemmiStructure.h"
#include "OpenByteSource.h"
#include "PQRFile.h"
#include "XYZFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

std::string Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

MoleculeFormat FormatOfName(const std::string& path)
{
  std::string name = Lower(path);
  for (const char* compression : { ".gz", ".bz2" })
  {
    if (EndsWith(name, compression))
    {
      name.resize(name.rfind('.'));
    }
  }
  const std::pair<const char*, MoleculeFormat> extensions[] = { { ".pdb", MoleculeFormat::PDB },
    { ".ent", MoleculeFormat::PDB }, { ".cif", MoleculeFormat::MMCIF },
    { ".mmcif", MoleculeFormat::MMCIF }, { ".pqr", MoleculeFormat::PQR },
    { ".xyz", MoleculeFormat::XYZ } };
  for (const auto& [extension, format] : extensions)
  {
    if (EndsWith(name, extension))
    {
      return format;
    }
  }
  return MoleculeFormat::ByName;
}

MoleculeFormat FormatOfText(std::string_view text, const std::string& path)
{
  if (text.substr(0, 5) == "data_" || text.find("\ndata_") != std::string_view::npos)
  {
    return MoleculeFormat::MMCIF;
  }
  for (const char* record : { "ATOM", "HETATM" })
  {
    const std::size_t at = text.find(record);
    if (at == 0 || (at != std::string_view::npos && text[at - 1] == '\n'))
    {
      return MoleculeFormat::PDB;
    }
  }
  throw std::runtime_error(path +
    ": neither the name (.pdb .ent .cif .pqr .xyz) nor the content says which format this is. Name "
    "the format.");
}

Macromolecule Parse(std::string_view text, const std::string& path, MoleculeFormat format,
  const StructureChoice& choice, const ProgressCallback& progress)
{
  if (format == MoleculeFormat::ByName)
  {
    format = FormatOfText(text, path);
  }
  const bool isStructure = format == MoleculeFormat::MMCIF || format == MoleculeFormat::PDB;
  if (!isStructure && !choice.Assembly.empty())
  {
    throw std::runtime_error(path + ": PQR and XYZ files describe no assemblies. Leave it empty.");
  }
  switch (format)
  {
    case MoleculeFormat::MMCIF:
      return ParseMMCIF(text, path, choice, progress);
    case MoleculeFormat::PQR:
      return ParsePQR(text, path, choice.Model, progress);
    case MoleculeFormat::XYZ:
      return ParseXYZ(text, path, choice.Model, progress);
    default:
      return ParsePDB(text, path, choice, progress);
  }
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
    throw std::runtime_error(
      path + ": there is no atom in it. Is the file whole, and what its name says?");
  }
}

/// "3 atoms have ...: FE of HEM 142 A, ..." when `has` holds for any.
template <typename Predicate>
std::string SentenceAbout(const Macromolecule& molecule, const char* what, Predicate has)
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
  if (count == 0)
  {
    return {};
  }
  return std::to_string(count) + (count == 1 ? " atom has " : " atoms have ") + what + ": " +
    names + (count > mostNamed ? ", ..." : "") + ".";
}

void AddSentence(std::vector<std::string>& to, const std::string& sentence)
{
  if (!sentence.empty())
  {
    to.push_back(sentence);
  }
}

void SetRadii(Macromolecule& molecule, RadiusTable table)
{
  for (Atom& atom : molecule.Atoms)
  {
    if (std::isnan(atom.Radius))
    {
      atom.Radius = VanDerWaalsRadius(atom.Element, table);
    }
  }
  AddSentence(molecule.Warnings,
    SentenceAbout(molecule, "no radius in the table (Radius is NaN)",
      [](const Atom& atom) { return std::isnan(atom.Radius); }));
  AddSentence(molecule.Notes,
    SentenceAbout(molecule, "the radius 0 in the file, and a charge",
      [](const Atom& atom) { return atom.Radius == 0.0 && atom.Charge != 0.0; }));
  const auto noCharge = [](const Atom& atom) { return std::isnan(atom.Charge); };
  AddSentence(molecule.Notes,
    std::all_of(molecule.Atoms.begin(), molecule.Atoms.end(), noCharge)
      ? "The file gives no charges: Charge is NaN for all atoms."
      : SentenceAbout(molecule, "no charge in the file (Charge is NaN)", noCharge));
}

}

Macromolecule ParseMacromolecule(std::string_view text, const std::string& path,
  const MoleculeOptions& options, const ProgressCallback& progress)
{
  Macromolecule molecule = Parse(
    text, path, options.Format, { options.Model, options.Assembly }, Between(progress, 0.0, 0.6));
  CheckModel(molecule, path, options.Model);
  Report(progress, 0.6);
  SelectAtoms(molecule, options);
  SetRadii(molecule, options.Radii);
  Report(progress, 0.7);
  if (options.BondsByDistance)
  {
    AddCovalentBonds(molecule, Between(progress, 0.7, 1.0));
  }
  else
  {
    SortBonds(molecule);
  }
  return molecule;
}

Macromolecule ReadMacromolecule(
  const std::string& path, const MoleculeOptions& options, const ProgressCallback& progress)
{
  const std::string text = ReadAll(*OpenByteSource(path), Between(progress, 0.0, 0.2));
  MoleculeOptions named = options;
  if (named.Format == MoleculeFormat::ByName)
  {
    named.Format = FormatOfName(path);
  }
  return ParseMacromolecule(text, path, named, Between(progress, 0.2, 1.0));
}

std::int64_t CountModels(const std::string& path, MoleculeFormat format)
{
  const std::string text = ReadAll(*OpenByteSource(path));
  if (format == MoleculeFormat::ByName)
  {
    format = FormatOfName(path);
  }
  if (format == MoleculeFormat::ByName)
  {
    format = FormatOfText(text, path);
  }
  if (format == MoleculeFormat::MMCIF || format == MoleculeFormat::XYZ)
  {
    return Parse(text, path, format, {}, {}).NumberOfModels;
  }
  constexpr std::string_view record = "MODEL ";
  std::int64_t count = text.compare(0, record.size(), record) == 0 ? 1 : 0;
  for (std::size_t at = text.find("\nMODEL "); at != std::string::npos;
       at = text.find("\nMODEL ", at + 1))
  {
    ++count;
  }
  return std::max<std::int64_t>(count, 1);
}

bool LooksLikeMolecule(const std::string& path)
{
  if (FormatOfName(path) == MoleculeFormat::ByName)
  {
    return false;
  }
  try
  {
    std::array<char, 4096> begin;
    const std::size_t size = OpenByteSource(path)->Read(0, begin.data(), begin.size());
    return std::find(begin.begin(), begin.begin() + static_cast<std::ptrdiff_t>(size), '\0') ==
      begin.begin() + static_cast<std::ptrdiff_t>(size);
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

}
