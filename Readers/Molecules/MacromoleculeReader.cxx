#include "Molecules/MacromoleculeReader.h"

#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Files/OpenByteSource.h"
#include "Files/TextLines.h"
#include "Molecules/AtomSelection.h"
#include "Molecules/BinaryCIF.h"
#include "Molecules/CoordinateUnits.h"
#include "Molecules/CovalentBonds.h"
#include "Molecules/ExchangeFormats.h"
#include "Molecules/GemmiStructure.h"
#include "Molecules/PQRFile.h"
#include "Molecules/PeriodicMolecules.h"
#include "Molecules/XYZFile.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cmath>
#include <memory>
#include <mutex>
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

/// A name in small letters, without the extension of a compression.
std::string RemoveCompressionSuffix(const std::string& path)
{
  std::string name = Lower(path);
  for (const char* compression : { ".gz", ".bz2" })
  {
    if (EndsWith(name, compression))
    {
      name.resize(name.rfind('.'));
    }
  }
  return name;
}

MoleculeFormat FormatFromName(const std::string& path)
{
  const std::string name = RemoveCompressionSuffix(path);
  const std::pair<const char*, MoleculeFormat> extensions[] = { { ".pdb", MoleculeFormat::PDB },
    { ".ent", MoleculeFormat::PDB }, { ".cif", MoleculeFormat::MMCIF },
    { ".mmcif", MoleculeFormat::MMCIF }, { ".bcif", MoleculeFormat::MMCIF },
    { ".pqr", MoleculeFormat::PQR }, { ".xyz", MoleculeFormat::XYZ },
    { ".extxyz", MoleculeFormat::XYZ }, { ".txyz", MoleculeFormat::XYZ },
    { ".arc", MoleculeFormat::XYZ }, { ".pdbqt", MoleculeFormat::PDBQT },
    { ".gro", MoleculeFormat::GRO }, { ".mol2", MoleculeFormat::MOL2 },
    { ".sdf", MoleculeFormat::SDF }, { ".mol", MoleculeFormat::SDF } };
  for (const auto& [extension, format] : extensions)
  {
    if (EndsWith(name, extension))
    {
      return format;
    }
  }
  const bool isNumbered = !name.empty() && name.back() >= '1' && name.back() <= '9';
  if (isNumbered && EndsWith(name.substr(0, name.size() - 1), ".pdb")) // biological units
  {
    return MoleculeFormat::PDB;
  }
  return MoleculeFormat::ByName;
}

/// Advice for a file in a format that is not supported; empty if the format is unknown.
std::string DescribeForeignFormat(const std::string& path)
{
  const std::string name = RemoveCompressionSuffix(path);
  const struct
  {
    const char* Extensions;
    const char* Message;
  } formats[] = {
    { ".mmtf ",
      "this is MMTF, which is not read; the PDB has retired it. Fetch the structure as mmCIF "
      "(.cif)." },
    { ".json .mmjson ",
      "this is mmJSON, which is not read. Convert it by 'gemmi convert FILE.json FILE.cif'." },
    { ".tpr ",
      "this is a run input of GROMACS, which is not read. Write its structure by 'gmx editconf -f "
      "FILE.tpr -o FILE.gro'." },
    { ".psf .prmtop .parm7 .top .itp ",
      "this is a topology: it has no coordinates. Open a structure (.pdb, .gro, .pqr), and create "
      "a PQR file with pdb2pqr or ParmEd if charges are needed." },
    { ".inpcrd .rst7 .restrt .ncrst ",
      "these are coordinates of AMBER without names of atoms. Write a PDB file by 'ambpdb -p "
      "TOPOLOGY -c FILE', or with cpptraj or MDAnalysis." },
    { ".crd .cor ",
      "these are coordinates of CHARMM or a trajectory of AMBER, which are not read. Write a PDB "
      "file with CHARMM, VMD, cpptraj or MDAnalysis." },
    { ".dcd .xtc .trr .nc .ncdf .mdcrd .h5md ",
      "this is a trajectory. Open its structure first, then use the Trajectory Reader, or write "
      "frames as PDB (gmx trjconv, cpptraj, MDAnalysis)." },
    { ".smi .inchi ",
      "this describes a molecule without coordinates. Generate coordinates with 'obabel FILE -O "
      "FILE.sdf --gen3d'." },
    { ".mae .maegz .cdx .cml .pse .cxs .hin .dms .gsd .poscar .cssr .molden .car .xsf ",
      "this format is not read. Write the molecule as PDB, mmCIF, MOL2 or SDF with the program "
      "that created it, or with 'obabel FILE -O FILE.mol2'." },
  };
  for (const auto& format : formats)
  {
    std::string_view rest = format.Extensions;
    for (auto extension = NextWord(rest); !extension.empty(); extension = NextWord(rest))
    {
      if (EndsWith(name, std::string(extension)))
      {
        return format.Message;
      }
    }
  }
  return {};
}

/// As text, or as it is if it is BinaryCIF.
std::unique_ptr<ByteSource> OpenMolecule(const std::string& path)
{
  std::array<char, 1000> begin{};
  const std::size_t size = OpenByteSource(path)->Read(0, begin.data(), begin.size());
  return IsBinaryCIF({ begin.data(), size }) ? OpenByteSource(path) : OpenTextSource(path);
}

bool BeginsAs(std::string_view text, std::string_view with)
{
  return text.size() >= with.size() &&
    std::equal(with.begin(), with.end(), text.begin(),
      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

/// The actual content of a file if it does not match its name, with advice; empty if unknown.
std::string DescribeForeignContent(std::string_view text, MoleculeFormat format)
{
  const std::string_view begin = text.substr(0, 1000);
  const auto has = [begin](std::string_view word) { return begin.find(word) != begin.npos; };
  const auto first = static_cast<unsigned char>(text.empty() ? ' ' : text[0]);
  // The first byte of a map in MessagePack, as which MMTF and BinaryCIF are written.
  const bool isMessagePack = (first >= 0x80 && first <= 0x8f) || first == 0xde || first == 0xdf;
  if (isMessagePack && has("mmtf"))
  {
    return "this is MMTF, which is not read; the PDB has retired it. Fetch the structure as mmCIF "
           "(.cif).";
  }
  if (isMessagePack && format != MoleculeFormat::MMCIF && IsBinaryCIF(text))
  {
    return "this is BinaryCIF. Name it .bcif, or choose mmCIF as its format.";
  }
  if (isMessagePack && format == MoleculeFormat::MMCIF && !IsBinaryCIF(text))
  {
    return "this is neither mmCIF nor BinaryCIF. The file may be damaged: fetch it again.";
  }
  const std::string_view words =
    text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (BeginsAs(words, "<!doctype html") || BeginsAs(words, "<html"))
  {
    return "this is a page of a web site, e.g. a message that the file was not found. Open it in a "
           "browser, and fetch "
           "the file again.";
  }
  if (BeginsAs(words, "<?xml") || BeginsAs(words, "<PDBx") || BeginsAs(words, "<cml"))
  {
    return "this is XML (PDBML, CML, ...), which is not read. Fetch or write the structure as "
           "mmCIF or PDB.";
  }
  if (BeginsAs(words, "version https://git-lfs"))
  {
    return "this is a pointer of Git LFS, not the file itself. Fetch it by 'git lfs pull'.";
  }
  if (BeginsAs(words, "{"))
  {
    return "this is JSON. If it is mmJSON, convert it with 'gemmi convert FILE.json FILE.cif'.";
  }
  for (const char* record : { "HEADER ", "CRYST1 ", "ATOM  ", "HETATM", "REMARK ", "MODEL  " })
  {
    if (format == MoleculeFormat::MMCIF && BeginsAs(words, record))
    {
      return "this is PDB, not mmCIF. Name it .pdb, or choose its format.";
    }
  }
  return {};
}

/// For names without a known extension. mmCIF first, since its text may contain PDB's words.
MoleculeFormat FormatFromText(std::string_view text, const std::string& path)
{
  if (IsBinaryCIF(text))
  {
    return MoleculeFormat::MMCIF;
  }
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
  std::string other = DescribeForeignFormat(path);
  other = other.empty() ? DescribeForeignContent(text, MoleculeFormat::ByName) : other;
  if (!other.empty())
  {
    throw std::runtime_error(path + ": " + other);
  }
  throw std::runtime_error(path +
    ": neither the name (.pdb .ent .cif .bcif .pqr .xyz .pdbqt .gro .mol2 .sdf .mol) nor the "
    "content "
    "says "
    "which format this is. Choose the format.");
}

Macromolecule Parse(std::string_view text, const std::string& path, MoleculeFormat format,
  const StructureChoice& choice, const ProgressCallback& progress)
{
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
    throw std::runtime_error(path +
      ": there is no atom in it. The file may be truncated, or its name may not match its "
      "content.");
  }
}

/// "3 atoms have ...: FE of HEM 142 A, ..." when `has` holds for any.
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

/// Properties of some atoms that are reported in messages.
struct RadiusFindings
{
  std::atomic<bool> NoRadius{ false }, ChargedPoint{ false }, NoCharge{ false }, Charge{ false };
};

bool IsChargedPoint(const Atom& atom)
{
  return atom.Radius == 0.0 && atom.Charge != 0.0;
}

void SetRadii(Macromolecule& molecule, RadiusTable table, RadiusFindings& found)
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
  RadiusFindings found;
  SetRadii(molecule, table, found);
  if (found.NoRadius)
  {
    AddSentence(molecule.Warnings,
      DescribeAtoms(molecule, "no radius in the table",
        [](const Atom& atom) { return std::isnan(atom.Radius); }));
  }
  if (found.ChargedPoint)
  {
    AddSentence(molecule.Notes,
      DescribeAtoms(molecule, "the radius 0 in the file, and a charge", IsChargedPoint));
  }
  if (!found.Charge)
  {
    AddSentence(molecule.Notes, "The file has no charges; Force Field Charges assigns them.");
  }
  else if (found.NoCharge)
  {
    AddSentence(molecule.Notes,
      DescribeAtoms(molecule, "no charge in the file",
        [](const Atom& atom) { return std::isnan(atom.Charge); }));
  }
}

}

void Check(const MoleculeOptions& options)
{
  RequireChoice("Format", options.Format, MoleculeFormat::SDF);
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
  if (mayHaveBonds)
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
  MoleculeOptions named = options;
  if (named.Format == MoleculeFormat::ByName)
  {
    named.Format = FormatFromName(path);
  }
  return ParseMacromolecule(text, path, named, Between(progress, 0.2, 1.0));
}

namespace
{

/// Numbers of lines that begin models or end them, and the first END.
struct Separators
{
  static constexpr std::uint64_t None = ~std::uint64_t{ 0 };
  static constexpr std::size_t MostFirstModels = 3;

  std::int64_t Models = 0;
  std::int64_t EndModels = 0;
  std::int64_t Ends = 0;
  std::uint64_t FirstEnd = None;
  std::vector<std::uint64_t> FirstModels; ///< where the first three of MODEL are

  Separators& operator+=(const Separators& other)
  {
    this->FirstModels.insert(
      this->FirstModels.end(), other.FirstModels.begin(), other.FirstModels.end());
    std::sort(this->FirstModels.begin(), this->FirstModels.end());
    this->FirstModels.resize(std::min(this->FirstModels.size(), MostFirstModels));
    this->Models += other.Models;
    this->EndModels += other.EndModels;
    this->Ends += other.Ends;
    this->FirstEnd = std::min(this->FirstEnd, other.FirstEnd);
    return *this;
  }
};

/// Those after the line ends of `text` but for its last `overlap` bytes; `text` is at `offset` of
/// the file, after a line end of its own if `hasLineEnd`.
Separators FindSeparators(
  std::string_view text, std::uint64_t offset, bool hasLineEnd, std::size_t overlap)
{
  Separators found;
  const std::size_t last = text.size() - std::min(overlap, text.size());
  const auto begins = [text](std::size_t at, std::string_view with)
  {
    return text.size() - at >= with.size() &&
      std::equal(with.begin(), with.end(), text.begin() + static_cast<std::ptrdiff_t>(at),
        [](char a, char b) { return a == b || (a == (b & ~0x20) && b >= 'a'); });
  };
  const auto isWord = [&](std::size_t at, std::string_view with)
  {
    const std::size_t end = at + with.size();
    return begins(at, with) && (end >= text.size() || text[end] <= ' ');
  };
  for (std::size_t at = text.find('\n'); at < last; at = text.find('\n', at + 1))
  {
    const std::uint64_t place = offset + at - (hasLineEnd && at > 0 ? 1 : 0);
    if (isWord(at, "\nMODEL"))
    {
      ++found.Models;
      if (found.FirstModels.size() < Separators::MostFirstModels)
      {
        found.FirstModels.push_back(place);
      }
    }
    if (begins(at, "\nENDMDL"))
    {
      ++found.EndModels;
    }
    else if (isWord(at, "\nEND"))
    {
      ++found.Ends;
      found.FirstEnd = std::min(found.FirstEnd, place);
    }
  }
  return found;
}

constexpr std::size_t LongestSeparator = 8; ///< "\nENDMDL" and one more

/// The same of a file without the whole text in memory, several parts of it at once.
Separators FindSeparators(ByteSource& source)
{
  constexpr std::uint64_t part = 1 << 20;
  const std::uint64_t size = source.MaximumBytes();
  std::mutex mutex;
  Separators all;
  ParallelFor(0, static_cast<std::int64_t>((size + part - 1) / part), 8,
    [&](std::int64_t first, std::int64_t last)
    {
      // A record belongs to the part that holds the end of the line before it.
      std::string text;
      for (auto p = static_cast<std::uint64_t>(first); p < static_cast<std::uint64_t>(last); ++p)
      {
        text.resize(part + LongestSeparator + 1);
        text[0] = '\n'; // before the file
        const std::size_t before = p == 0 ? 1 : 0;
        text.resize(before + source.Read(p * part, &text[before], part + LongestSeparator));
        const std::size_t overlap = text.size() > part + before ? text.size() - part - before : 0;
        const Separators found = FindSeparators(text, p * part, p == 0, overlap);
        const std::lock_guard<std::mutex> lock(mutex);
        all += found;
      }
    });
  return all;
}

/// Whether the number of models is that of MODEL records, or one because nothing but a few lines
/// follows END. Other files have to be read.
bool IsCountedByRecords(const Separators& found, ByteSource& source)
{
  if (found.EndModels <= found.Models && (found.Models > 0 || found.Ends == 0))
  {
    return true;
  }
  if (found.EndModels > 0 || found.Ends > 1)
  {
    return false;
  }
  std::string after(std::size_t{ 1 } << 16, ' ');
  const std::size_t size = source.Read(found.FirstEnd, after.data(), after.size());
  const bool isWhole = size < after.size();
  after.resize(size);
  return isWhole && Lower(after).find("\natom") == std::string::npos &&
    Lower(after).find("\nheta") == std::string::npos;
}

}

namespace
{

/// Whether the first two of MODEL records are models, so that all are. The file is read up to the
/// third one.
bool AreFirstModelsApart(const Separators& found, ByteSource& source, ModelCombination combine)
{
  if (found.Models < 2 || combine == ModelCombination::Never)
  {
    return true;
  }
  const bool isMore = found.FirstModels.size() == Separators::MostFirstModels;
  std::string text(isMore ? found.FirstModels.back() : source.MaximumBytes(), ' ');
  text.resize(source.Read(0, text.data(), text.size()));
  return CountPDBModels(text, combine) > 1;
}

}

std::int64_t CountModels(
  const std::string& path, MoleculeFormat format, Macromolecule* parsed, ModelCombination combine)
{
  const auto source = OpenMolecule(path);
  if (format == MoleculeFormat::ByName)
  {
    format = FormatFromName(path);
  }
  const bool isByRecord = format == MoleculeFormat::PDB || format == MoleculeFormat::PQR;
  Separators found;
  // Without reading atoms, since ParaView asks for time steps whenever a file is opened.
  if (isByRecord && source->RandomAccess())
  {
    found = FindSeparators(*source);
  }
  if (isByRecord && source->RandomAccess() && IsCountedByRecords(found, *source) &&
    (format == MoleculeFormat::PQR || AreFirstModelsApart(found, *source, combine)))
  {
    return std::max<std::int64_t>(found.Models, 1);
  }
  const std::string text = ReadAll(*source);
  if (format == MoleculeFormat::ByName)
  {
    format = FormatFromText(text, path);
  }
  if (format == MoleculeFormat::PQR)
  {
    return CountPQRModels(text);
  }
  if (format == MoleculeFormat::PDB)
  {
    return CountPDBModels(text, combine);
  }
  Macromolecule molecule = Parse(text, path, format, {}, {});
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
