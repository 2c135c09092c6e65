/**
 * @file PDBText.h
 * @brief Lines of PDB files for tests, column by column.
 */
#ifndef isthmus_PDBText_h
#define isthmus_PDBText_h

#include "Atoms/ChemicalElement.h"
#include "MoleculeTexts.h"
#include "SharedData.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace isthmus::testing
{

/// Columns 13-16 and 18-27 as they are in the file; `tail` begins at column 55.
inline std::string AtomLine(const std::string& serial, const std::string& name,
  const std::string& residue, double x, double y = 0.0, double z = 0.0,
  const std::string& tail = "  1.00  0.00", bool isHetero = false)
{
  std::array<char, 200> line;
  std::snprintf(line.data(), line.size(), "%-6s%5s %-4s %-10s   %8.3f%8.3f%8.3f%s\n",
    isHetero ? "HETATM" : "ATOM", serial.c_str(), name.c_str(), residue.c_str(), x, y, z,
    tail.c_str());
  return line.data();
}

inline Macromolecule FromPDB(const std::string& text, std::int64_t model = 0)
{
  MoleculeOptions options;
  options.ModelIndex = model;
  return ParseMolecule(text, MoleculeFormat::PDB, options);
}

/// A file of the bug reports, plain or compressed.
inline Macromolecule FromReport(const std::string& name, std::int64_t model = 0)
{
  MoleculeOptions options;
  options.ModelIndex = model;
  return ReadMacromolecule((SharedDataFolder() / "reports" / name).string(), options);
}

/// "Na Cl X " of the atoms.
inline std::string JoinElements(const Macromolecule& molecule)
{
  std::string symbols;
  for (const Atom& atom : molecule.Atoms)
  {
    symbols += std::string(ElementSymbol(atom.Element)) + " ";
  }
  return symbols;
}

/// "CA of SER 10A A, ..." of the atoms.
inline std::string Descriptions(const Macromolecule& molecule)
{
  std::string all;
  for (const Atom& atom : molecule.Atoms)
  {
    all += (all.empty() ? "" : ", ") + Describe(atom);
  }
  return all;
}

inline bool Mention(const std::vector<std::string>& sentences, const std::string& words)
{
  for (const std::string& sentence : sentences)
  {
    if (sentence.find(words) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

}

#endif
