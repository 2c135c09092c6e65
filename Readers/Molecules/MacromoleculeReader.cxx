#include "Molecules/MacromoleculeReader.h"

#include "Core/ParallelFor.h"
#include "Files/OpenByteSource.h"
#include "Files/TextLines.h"
#include "Molecules/AtomSelection.h"
#include "Molecules/CovalentBonds.h"
#include "Molecules/ExchangeFormats.h"
#include "Molecules/GemmiStructure.h"
#include "Molecules/PQRFile.h"
#include "Molecules/XYZFile.h"

#include <algorithm>
#include <atomic>
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
    { ".xyz", MoleculeFormat::XYZ }, { ".extxyz", MoleculeFormat::XYZ },
    { ".txyz", MoleculeFormat::XYZ }, { ".arc", MoleculeFormat::XYZ },
    { ".pdbqt", MoleculeFormat::PDBQT }, { ".gro", MoleculeFormat::GRO },
    { ".mol2", MoleculeFormat::MOL2 }, { ".sdf", MoleculeFormat::SDF },
    { ".mol", MoleculeFormat::SDF } };
  for (const auto& [extension, format] : extensions)
  {
    if (EndsWith(name, extension))
    {
      return format;
    }
  }
  return MoleculeFormat::ByName;
}

/// What to do with a file in a format that is not read; empty: it is not known.
std::string OtherFormat(const std::string& path, std::string_view text)
{
  const std::string name = Lower(path);
  const struct
  {
    const char* Extensions;
    const char* Sentence;
  } formats[] = {
    { ".bcif ",
      "this is BinaryCIF, which is not read. Fetch or write the structure as mmCIF (.cif)." },
    { ".mmtf ",
      "this is MMTF, which is not read; the PDB has retired it. Fetch the structure as mmCIF "
      "(.cif)." },
    { ".json .mmjson ",
      "this is mmJSON, which is not read. Convert it by 'gemmi convert FILE.json FILE.cif'." },
    { ".psf .prmtop .parm7 .top .itp .tpr ",
      "this is a topology: it has no coordinates. Open a structure (.pdb, .gro, .pqr), and let "
      "pdb2pqr "
      "or ParmEd write a PQR file where charges are needed." },
    { ".dcd .xtc .trr .nc .ncdf .mdcrd .crd .h5md ",
      "this is a trajectory. Open its structure first, then use the Trajectory Reader, or write "
      "frames as "
      "PDB (gmx trjconv, cpptraj, MDAnalysis)." },
    { ".mae .maegz .cdx .cml .smi .inchi .pse .cxs .hin ",
      "this format is not read. Write the molecule as PDB, mmCIF, MOL2 or SDF with the program "
      "that made "
      "it, or by 'obabel FILE -O FILE.mol2'." },
  };
  for (const auto& format : formats)
  {
    std::string_view rest = format.Extensions;
    for (auto extension = NextWord(rest); !extension.empty(); extension = NextWord(rest))
    {
      if (EndsWith(name, std::string(extension)))
      {
        return format.Sentence;
      }
    }
  }
  if (text.substr(0, 1) == "{")
  {
    return "this is JSON. Where it is mmJSON, convert it by 'gemmi convert FILE.json FILE.cif'.";
  }
  return {};
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
  if (text.find("@<TRIPOS>MOLECULE") != std::string_view::npos)
  {
    return MoleculeFormat::MOL2;
  }
  const std::string other = OtherFormat(path, text);
  if (!other.empty())
  {
    throw std::runtime_error(path + ": " + other);
  }
  throw std::runtime_error(path +
    ": neither the name (.pdb .ent .cif .pqr .xyz .pdbqt .gro .mol2 .sdf .mol) nor the content "
    "says "
    "which format this is. Name the format.");
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
    throw std::runtime_error(
      path + ": only PDB and mmCIF files describe assemblies. Leave Assembly empty.");
  }
  switch (format)
  {
    case MoleculeFormat::MMCIF:
      return ParseMMCIF(text, path, choice, progress);
    case MoleculeFormat::PQR:
      return ParsePQR(text, path, choice.Model, progress);
    case MoleculeFormat::XYZ:
      return ParseXYZ(text, path, choice.Model, progress);
    case MoleculeFormat::PDBQT:
    case MoleculeFormat::GRO:
    case MoleculeFormat::MOL2:
    case MoleculeFormat::SDF:
      return ParseExchangeFormat(text, path, format, choice.Model, progress);
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

/// What some atoms have, or lack, that sentences tell of.
struct Peculiarities
{
  std::atomic<bool> NoRadius{ false }, ChargedPoint{ false }, NoCharge{ false }, Charge{ false };
};

bool IsChargedPoint(const Atom& atom)
{
  return atom.Radius == 0.0 && atom.Charge != 0.0;
}

void SetRadii(Macromolecule& molecule, RadiusTable table, Peculiarities& found)
{
  constexpr std::int64_t atomsAtOnce = 1 << 14;
  ParallelFor(0, static_cast<std::int64_t>(molecule.Atoms.size()), atomsAtOnce,
    [&](std::int64_t first, std::int64_t last)
    {
      bool noRadius = false, chargedPoint = false, noCharge = false, charge = false;
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        Atom& atom = molecule.Atoms[i];
        atom.Radius =
          std::isnan(atom.Radius) ? VanDerWaalsRadius(atom.Element, table) : atom.Radius;
        noRadius = noRadius || std::isnan(atom.Radius);
        chargedPoint = chargedPoint || IsChargedPoint(atom);
        noCharge = noCharge || std::isnan(atom.Charge);
        charge = charge || !std::isnan(atom.Charge);
      }
      found.NoRadius = found.NoRadius || noRadius;
      found.ChargedPoint = found.ChargedPoint || chargedPoint;
      found.NoCharge = found.NoCharge || noCharge;
      found.Charge = found.Charge || charge;
    });
}

void SetRadii(Macromolecule& molecule, RadiusTable table)
{
  Peculiarities found;
  SetRadii(molecule, table, found);
  if (found.NoRadius)
  {
    AddSentence(molecule.Warnings,
      SentenceAbout(molecule, "no radius in the table (Radius is NaN)",
        [](const Atom& atom) { return std::isnan(atom.Radius); }));
  }
  if (found.ChargedPoint)
  {
    AddSentence(molecule.Notes,
      SentenceAbout(molecule, "the radius 0 in the file, and a charge", IsChargedPoint));
  }
  if (!found.Charge)
  {
    AddSentence(molecule.Notes, "The file gives no charges: Charge is NaN for all atoms.");
  }
  else if (found.NoCharge)
  {
    AddSentence(molecule.Notes,
      SentenceAbout(molecule, "no charge in the file (Charge is NaN)",
        [](const Atom& atom) { return std::isnan(atom.Charge); }));
  }
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

namespace
{

constexpr std::string_view ModelLine = "\nMODEL ";

/// Lines that begin with MODEL; `text` begins at a line or with the end of one.
std::int64_t CountLines(std::string_view text)
{
  std::int64_t count = 0;
  for (std::size_t at = text.find(ModelLine); at != std::string_view::npos;
       at = text.find(ModelLine, at + 1))
  {
    ++count;
  }
  return count;
}

/// Models of PDB and PQR: their records, or the one that has none.
std::int64_t CountRecords(std::string_view text)
{
  const bool first = text.substr(0, ModelLine.size() - 1) == ModelLine.substr(1);
  return std::max<std::int64_t>((first ? 1 : 0) + CountLines(text), 1);
}

/// The same without the whole text in memory, several parts of it at once.
std::int64_t CountRecords(ByteSource& source)
{
  constexpr std::uint64_t part = 1 << 20;
  const std::uint64_t size = source.MostBytes();
  std::atomic<std::int64_t> count{ 0 };
  ParallelFor(0, static_cast<std::int64_t>((size + part - 1) / part), 8,
    [&](std::int64_t first, std::int64_t last)
    {
      // A record belongs to the part that holds the end of the line before it.
      std::string text;
      for (auto p = static_cast<std::uint64_t>(first); p < static_cast<std::uint64_t>(last); ++p)
      {
        text.resize(part + ModelLine.size());
        text[0] = '\n'; // before the file
        const std::size_t before = p == 0 ? 1 : 0;
        text.resize(before + source.Read(p * part, &text[before], part + ModelLine.size() - 1));
        count += CountLines(text);
      }
    });
  return std::max<std::int64_t>(count, 1);
}

}

std::int64_t CountModels(const std::string& path, MoleculeFormat format)
{
  const auto source = OpenByteSource(path);
  if (format == MoleculeFormat::ByName)
  {
    format = FormatOfName(path);
  }
  const bool isByRecord = format == MoleculeFormat::PDB || format == MoleculeFormat::PQR;
  if (isByRecord && source->RandomAccess())
  {
    return CountRecords(*source);
  }
  const std::string text = ReadAll(*source);
  if (format == MoleculeFormat::ByName)
  {
    format = FormatOfText(text, path);
  }
  if (format != MoleculeFormat::PDB && format != MoleculeFormat::PQR)
  {
    return Parse(text, path, format, {}, {}).NumberOfModels;
  }
  return CountRecords(text);
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
