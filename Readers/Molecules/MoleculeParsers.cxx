#include "Molecules/MoleculeParsers.h"

#include "Files/TextLines.h"
#include "Molecules/BinaryCIF.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

namespace isthmus
{
namespace
{

#define ISTHMUS_FORMAT_ROW(Name, Label, Endings)                                                   \
  MoleculeFormatRow{ MoleculeFormat::Name, Label, Endings, Parse##Name, Is##Name },
constexpr std::array<MoleculeFormatRow, NumberOfMoleculeFormats> Formats{
  { ISTHMUS_MOLECULE_FORMATS(ISTHMUS_FORMAT_ROW) }
};

/// Calls `take(ending)` for each word of a list.
template <typename Take>
void ForEachEnding(std::string_view endings, Take&& take)
{
  for (auto ending = NextWord(endings); !ending.empty(); ending = NextWord(endings))
  {
    take("." + std::string(ending));
  }
}

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

bool BeginsAs(std::string_view text, std::string_view with)
{
  return text.size() >= with.size() &&
    std::equal(with.begin(), with.end(), text.begin(),
      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

}

const MoleculeFormatRow& FindFormat(MoleculeFormat format)
{
  return Formats.at(static_cast<std::size_t>(format) - 1);
}

const std::string& MoleculeEndings()
{
  static const std::string endings = []
  {
    std::string all;
    for (const MoleculeFormatRow& row : Formats)
    {
      ForEachEnding(row.Endings, [&all](const std::string& ending) { all += ending + " "; });
    }
    return all;
  }();
  return endings;
}

MoleculeFormat FormatFromName(const std::string& path)
{
  const std::string name = RemoveCompressionSuffix(path);
  MoleculeFormat found = MoleculeFormat::ByName;
  for (const MoleculeFormatRow& row : Formats)
  {
    ForEachEnding(row.Endings,
      [&](const std::string& ending) { found = EndsWith(name, ending) ? row.Format : found; });
  }
  return found;
}

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

MoleculeFormat FormatFromText(std::string_view text, const std::string& path)
{
  for (const MoleculeFormatRow& row : Formats)
  {
    if (row.IsFormat(text))
    {
      return row.Format;
    }
  }
  std::string other = DescribeForeignFormat(path);
  other = other.empty() ? DescribeForeignContent(text, MoleculeFormat::ByName) : other;
  if (!other.empty())
  {
    throw std::runtime_error(path + ": " + other);
  }
  throw std::runtime_error(path + ": neither the name (" + MoleculeEndings() +
    "and the same with .gz or .bz2) nor the content says which format this is. Choose the format.");
}

}
