/**
 * @class   vtkMacromoleculeReader
 * @brief   atoms and bonds from files of molecules
 *
 * Formats and endings of file names are those of MoleculeFormats.h, plain, .gz or .bz2; for other
 * names, the format is detected from the content.
 *
 * **Output 0**, vtkPolyData: a point and a vertex for each atom (angstrom, double), a line for each
 * bond. Point arrays:
 *
 * - `Radius` (double): van der Waals radius in angstrom, the file's (PQR) or that of RadiusTable;
 *   NaN: none
 * - `Charge` (double): in e, the file's (PQR, PDBQT, MOL2), or its formal charge (PDB, mmCIF) where
 *   not 0; NaN: none
 * - `Element` (unsigned short): atomic number, 0: unknown or none (beads, ghost and dummy atoms);
 *   its symbol is in `ElementSymbols` of the field data
 * - `AtomName`, `ResidueName`, `Chain` (string): the authors' names (auth_ of mmCIF); empty: none
 * - `ResidueId` (int): the authors' residue number
 * - `BFactor` (double): angstrom^2; NaN: none
 * - `Occupancy` (double): NaN: none
 * - `IsHetero` (unsigned char): 1: a HETATM record
 *
 * and, where the file has any, `InsertionCode` and (with AltLoc "*") `AltLoc`, strings, and `pLDDT`
 * (double, 0 to 100): confidence of predicted residues, by ModelCIF or the B factors of PDB files
 * whose title names AlphaFold, ESMFold, ColabFold or OpenFold; `SecondaryStructure` (unsigned char)
 * by HELIX and SHEET, or struct_conf and struct_sheet_range: 0 coil, 1 alpha helix, 2 strand, 3
 * 3-10 helix, 4 pi helix (not of an assembly). Cell array `BondSource` (unsigned char): 0 vertex, 1
 * bond named by the file (CONECT, SSBOND, LINK, struct_conn), 2 bond by distance (CovalentBonds.h).
 * Bond orders are not known. Atoms are in the order of the file, except that the atoms of a residue
 * are consecutive.
 *
 * Several models are time steps (ModelsAsTimeSteps). This includes models that are separated by END
 * in a PDB file, if they repeat the same atoms, and excludes copies beside each other
 * (CombineModels, PDBLines.h). Field data: `NumberOfModels`;
 * `ElementSymbols` (string 6 is "C"); `Notes` and `Warnings`: what was dropped or is missing, one
 * message each. Warnings also go to vtkWarningMacro: elements that are missing in the file, and
 * atoms without a radius.
 *
 * **Output 1**, vtkMolecule: the same atoms and bonds (order 1) and point arrays, for molecule
 * mappers.
 *
 * **Errors** (one message, error code, empty outputs): a file that is missing, truncated, of
 * another format, without atoms, or with coordinates that are not finite; a model, chain, assembly
 * or alternate location that does not exist.
 *
 * **Truncated files.** GRO, MOL2 and SDF files have counts and an end, XYZ files counts: one that
 * is truncated is an error, except that an SDF file without M  END and $$$$ is read with a warning
 * if its counts are right. PDB, PDBQT, PQR and mmCIF files have neither: one that is truncated
 * between two records is read as a shorter one (a PDB file may end without END), and one that ends
 * within a record is an error where that can be seen. Where it cannot: a record of PDB that ends
 * with one of its fields has no values for further ones (occupancy, B factor, charge, bonds of
 * CONECT). If no line end follows the last number of a PQR, XYZ or mmCIF file, or of a MOL2 file
 * without bonds, digits of it may be missing: such a file cannot be distinguished from a whole one.
 *
 * **Cost.** O(bytes + n log n) for n atoms, including all bonds; about 800 bytes for each atom.
 * Progress and abort work while reading, except that gemmi parses mmCIF in one call. On several MPI
 * ranks, the first one has the whole molecule.
 */
#ifndef vtkMacromoleculeReader_h
#define vtkMacromoleculeReader_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Molecules/MoleculeOptions.h"
#include "vtkIsthmusReadersMoleculesModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <cstdint> // for models
#include <memory>
#include <string> // for the properties

class vtkMolecule;

class VTKISTHMUSREADERSMOLECULES_EXPORT vtkMacromoleculeReader : public vtkPolyDataAlgorithm
{
public:
  static vtkMacromoleculeReader* New();
  vtkTypeMacro(vtkMacromoleculeReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the file. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// Of MoleculeFormats.h: PDB = 1, MMCIF, PQR, ...
  enum Formats
  {
    ByName = 0,
    ISTHMUS_MOLECULE_FORMATS(ISTHMUS_FORMAT_NAME)
  };

  ///@{
  /// Default ByName: inferred from the extension, otherwise from the content.
  ISTHMUS_PARAMETER(Format, int);
  ///@}

  enum LengthUnits
  {
    ByFormat = 0,
    Angstrom = 1,
    Nanometre = 2,
    Bohr = 3
  };

  ///@{
  /// Unit of the coordinates and the cell in the file. Default ByFormat: nanometre in GRO files,
  /// else angstrom. A warning says where the distances of atoms do not fit the unit. The output is
  /// in angstrom.
  ISTHMUS_PARAMETER(LengthUnit, int);
  ///@}

  ///@{
  /// Index of the model (MODEL of PDB, frame of XYZ), from 0. Default 0.
  ISTHMUS_PARAMETER(ModelIndex, int);
  ///@}

  ///@{
  /// Whether the models are time steps 0, 1, ..., so that the time which the pipeline requests
  /// chooses the model. A ModelIndex above 0 selects that model at all times. Default on.
  vtkSetMacro(ModelsAsTimeSteps, bool);
  vtkGetMacro(ModelsAsTimeSteps, bool);
  vtkBooleanMacro(ModelsAsTimeSteps, bool);
  ///@}

  enum ModelCombinations
  {
    Automatic = 0,
    Never = 1,
    Always = 2
  };

  ///@{
  /// Whether the models of a PDB file are read as one structure. Automatic (default): where they
  /// are rigid copies beside each other, as in a file of a biological unit (.pdb1), whose copies
  /// are models; a note says so. Models that overlap, as those of an NMR ensemble, stay models.
  ISTHMUS_PARAMETER(CombineModels, int);
  ///@}

  ///@{
  /// Name of a biological assembly that a PDB or mmCIF file describes ("1"): its chains are copied
  /// as described. Default empty: the atoms of the file.
  ISTHMUS_PARAMETER(Assembly, const std::string&);
  ///@}

  ///@{
  /// Names of the chains to read, separated by blanks or commas. Default empty: all.
  ISTHMUS_PARAMETER(Chains, const std::string&);
  ///@}

  ///@{
  /// Alternate locations: a letter, "*" for all, or empty (default) for the location with the
  /// highest occupancy in each residue.
  ISTHMUS_PARAMETER(AltLoc, const std::string&);
  ///@}

  ///@{
  /// Read HETATM atoms that are not water; read water. Default on.
  ISTHMUS_PARAMETER_SWITCH(ReadHetero);
  ISTHMUS_PARAMETER_SWITCH(ReadWater);
  ///@}

  enum RadiusTables
  {
    Bondi = 0,
    Alvarez = 1
  };

  ///@{
  /// Radii for files without radii: Bondi (1964, default; few metals) or Alvarez (2013; nearly all
  /// elements). See AtomRadii.h.
  ISTHMUS_PARAMETER(RadiusTable, int);
  ///@}

  ///@{
  /// Find bonds by distance in addition to those in the file. Default on.
  ISTHMUS_PARAMETER_SWITCH(BondsByDistance);
  ///@}

  /// Output 1.
  vtkMolecule* GetMolecule();

  /// 1 if the file exists, has a name as above, and is text or BinaryCIF.
  static int CanReadFile(const char* fileName);

  /// ".pdb .pdb1 ...", without those of compressed files.
  static const char* GetFileExtensions();

  /// The arrays that the reader adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkMacromoleculeReader();
  ~vtkMacromoleculeReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMacromoleculeReader(const vtkMacromoleculeReader&) = delete;
  void operator=(const vtkMacromoleculeReader&) = delete;

  void Read(std::int64_t model, vtkPolyData* atoms, vtkMolecule* molecule);
  std::int64_t CountModels();
  std::int64_t GetModel(vtkInformation* request);

  char* FileName = nullptr;
  isthmus::MoleculeOptions Parameters;
  bool ModelsAsTimeSteps = true;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
