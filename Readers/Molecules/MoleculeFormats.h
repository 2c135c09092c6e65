/**
 * @file MoleculeFormats.h
 * @brief The formats of molecule files: the only list of their names and of the endings of files.
 *
 * The reader, its panel (Plugin/MacromoleculeReader.xml), file dialogs, the Python package and the
 * command `isthmus` take formats from here. A row has
 *
 * - the name: MoleculeFormat::NAME and vtkMacromoleculeReader::NAME, numbered from 1 in this order.
 *   ParseNAME reads a text and IsNAME recognises one (MoleculeParsers.h); both are in the source
 *   of the format;
 * - the name in panels and in Python ("XYZ" is format="xyz");
 * - the endings of file names, in small letters; each may be followed by .gz or .bz2.
 *
 * Wrapping/Python/panel_files.py reads the rows: one on each line.
 */
#ifndef isthmus_MoleculeFormats_h
#define isthmus_MoleculeFormats_h

// clang-format off
#define ISTHMUS_MOLECULE_FORMATS(FORMAT) \
  FORMAT(PDB, "PDB", "pdb pdb1 pdb2 pdb3 pdb4 pdb5 pdb6 pdb7 pdb8 pdb9 ent") \
  FORMAT(MMCIF, "mmCIF, BinaryCIF", "cif mmcif bcif") \
  FORMAT(PQR, "PQR", "pqr") \
  FORMAT(XYZ, "XYZ", "xyz extxyz txyz arc") \
  FORMAT(PDBQT, "PDBQT", "pdbqt") \
  FORMAT(GRO, "GRO", "gro") \
  FORMAT(MOL2, "MOL2", "mol2") \
  FORMAT(SDF, "SDF", "sdf mol")
// clang-format on

#define ISTHMUS_FORMAT_NAME(Name, Label, Endings) Name,
#define ISTHMUS_COUNT_FORMAT(Name, Label, Endings) +1

namespace isthmus
{

enum class MoleculeFormat
{
  ByName, ///< from the ending of the file's name, else from its content
  ISTHMUS_MOLECULE_FORMATS(ISTHMUS_FORMAT_NAME)
};

constexpr int NumberOfMoleculeFormats = 0 ISTHMUS_MOLECULE_FORMATS(ISTHMUS_COUNT_FORMAT);

}

#endif
