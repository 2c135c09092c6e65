/**
 * @file MoleculeTexts.h
 * @brief Molecules as texts, and the results of reading them.
 */
#ifndef isthmus_MoleculeTexts_h
#define isthmus_MoleculeTexts_h

#include "Molecules/MacromoleculeReader.h"

#include <string>

namespace isthmus::testing
{

inline Macromolecule ParseMolecule(
  const std::string& text, MoleculeFormat format, MoleculeOptions options = MoleculeOptions())
{
  options.Format = format;
  return ParseMacromolecule(text, "test", options);
}

inline std::string CatchMessage(
  const std::string& text, MoleculeFormat format, const MoleculeOptions& options = {})
{
  try
  {
    ParseMolecule(text, format, options);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return {};
}

inline std::string JoinNames(const Macromolecule& molecule)
{
  std::string names;
  for (const Atom& atom : molecule.Atoms)
  {
    names += atom.Name + (atom.AltLoc == ' ' ? "" : std::string(1, atom.AltLoc)) + " ";
  }
  return names;
}

// Two conformers of a serine, an iron with formal charge, water, a second model.
inline const char* const SmallPDB =
  "MODEL        1\n"
  "ATOM      1  CA  SER A  10A      0.000   0.000   0.000  1.00 10.00           C  \n"
  "ATOM      2  CB ASER A  10A      1.500   0.000   0.000  0.40 11.00           C  \n"
  "ATOM      3  CB BSER A  10A      0.000   1.500   0.000  0.60 12.00           C  \n"
  "ATOM      4  OG ASER A  10A      2.000   1.300   0.000  0.40 13.00           O  \n"
  "ATOM      5  OG BSER A  10A      1.300   2.000   0.000  0.60                 O  \n"
  "TER\n"
  "HETATM    6 FE   HEM B 142      10.000   0.000   0.000  1.00 14.00          FE3+\n"
  "HETATM    7  O   HOH C   1      12.000   0.000   0.000  1.00 15.00           O  \n"
  "ENDMDL\n"
  "MODEL        2\n"
  "ATOM      1  CA  SER A  10A      5.000   0.000   0.000  1.00 10.00           C  \n"
  "ENDMDL\n"
  "CONECT    6    7\n"
  "CONECT    7    6\n";

}

#endif
