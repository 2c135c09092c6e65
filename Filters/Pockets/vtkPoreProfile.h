/**
 * @class   vtkPoreProfile
 * @brief   Measures the radius along pores and channels of a molecule, and lists the residues that
 * line them.
 *
 * Input: atoms, i.e. points with the array `Radius` (input array 0), as created by
 * vtkMacromoleculeReader. If the atoms have names, water, ions and ligands are dropped (the field
 * array `Notes` lists them); hydrogens are kept, unlike in vtkMolecularPockets.
 *
 * Alternatively, a closed surface (polygons without a radius), for example that of a map from
 * vtkMapSurface: its points are used as atoms of radius 0, so radii are too large by about h^2 / 6r
 * for edges of length h. Channels narrower than the longest edge cannot be distinguished from the
 * gaps between points and are omitted.
 *
 * Mode Automatic finds the channels through the molecule; TwoPoints follows the pore from Point1 to
 * Point2; PointAndDirection uses planes perpendicular to Direction, both ways from Point, as HOLE
 * does. CellVectors finds the widest ways through a crystal along the vectors a, b and c of its
 * periodic cell (field array `CellVectors`), whose atoms must all be there. The definitions are in
 * PoreProfile.h and PoreChannels.h.
 *
 * Outputs, whose arrays OutputArrayTable() lists:
 *  - 0: vtkPolyData, one polyline per pore, through the centers of the largest balls;
 *  - 1: vtkTable, the same samples as rows, for a chart;
 *  - 2: vtkTable, one row per pore; with CellVectors its field data have the radius and the center
 *    of the largest ball between the atoms;
 *  - 3: vtkPolyData, bottlenecks: points at local minima of the radius;
 *  - 4: vtkTable, lining residues: `PoreId` and the columns of vtkMolecularPockets;
 *  - 5: vtkPolyData, tubes with the radii of the pores;
 *  - 6: vtkPolyData, all atoms of the lining residues, with their bonds, the input's point arrays
 *    and `PoreId`.
 *
 * **Errors** (message, empty outputs): missing radii; radii, points or options out of range; no
 * path between the points; no periodic cell for CellVectors. A molecule without channels is not an
 * error.
 *
 * **Cost.** Linear in planes and in the atoms near them. Results are bitwise the same on any number
 * of threads.
 */
#ifndef vtkPoreProfile_h
#define vtkPoreProfile_h

#include "Core/ArrayProperty.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Pockets/Pore.h"
#include "vtkIsthmusFiltersPocketsModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the properties
#include <vector> // for the table of output arrays

class vtkPointSet;
class vtkTable;

class VTKISTHMUSFILTERSPOCKETS_EXPORT vtkPoreProfile : public vtkPolyDataAlgorithm
{
public:
  static vtkPoreProfile* New();
  vtkTypeMacro(vtkPoreProfile, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Input array 0 is the point array of the radii, `Radius` by default.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  enum RadiusTables
  {
    OfInput = 0,
    Hole = 1
  };

  ///@{
  /// OfInput (default): the radii of the input array. Hole: the simple radii of HOLE by element, as
  /// isthmus::RadiusTable::UnitedAtom; an element that is not in the table keeps the radius of the
  /// input.
  vtkSetMacro(RadiusTable, int);
  vtkGetMacro(RadiusTable, int);
  ///@}

  enum Modes
  {
    Automatic = 0,
    TwoPoints = 1,
    PointAndDirection = 2,
    CellVectors = 3
  };

  ///@{
  /// Which pores to find. Default: Automatic.
  vtkSetMacro(Mode, int);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /// The ends of the pore in angstrom, for TwoPoints. Default: the origin.
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  ///@}

  ///@{
  /// A point in the pore (angstrom) and the direction along it, for PointAndDirection. Default:
  /// origin, z.
  vtkSetVector3Macro(Point, double);
  vtkGetVector3Macro(Point, double);
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /// Radius at which a pore ends. Default: 5 angstrom.
  ISTHMUS_PARAMETER(EndRadius, double);
  ///@}

  ///@{
  /// Distance between the planes. Default: 0.25 angstrom.
  ISTHMUS_PARAMETER(Spacing, double);
  ///@}

  ///@{
  /// Smallest radius of channels, for Automatic. Default: 1 angstrom.
  ISTHMUS_PARAMETER(MinimumRadius, double);
  ///@}

  ///@{
  /// Smallest distance between the ends of a channel, for Automatic. Default: 20 angstrom.
  ISTHMUS_PARAMETER(MinimumSpan, double);
  ///@}

  ///@{
  /// Maximum number of channels, for Automatic. Default: 20.
  ISTHMUS_PARAMETER(MaximumPores, int);
  ///@}

  ///@{
  /// Largest distance of the path from the straight line, for TwoPoints. Default: 10 angstrom.
  ISTHMUS_PARAMETER(MaximumOffset, double);
  ///@}

  ///@{
  /// Residues and atoms that count as part of the molecule in addition to its chains. Default:
  /// hydrogens.
  vtkSetMacro(IncludeHydrogens, bool);
  vtkGetMacro(IncludeHydrogens, bool);
  vtkBooleanMacro(IncludeHydrogens, bool);
  vtkSetMacro(IncludeIons, bool);
  vtkGetMacro(IncludeIons, bool);
  vtkBooleanMacro(IncludeIons, bool);
  vtkSetMacro(IncludeLigands, bool);
  vtkGetMacro(IncludeLigands, bool);
  vtkBooleanMacro(IncludeLigands, bool);
  ///@}

  ///@{
  /// Residues of a predicted model with a confidence (point array `pLDDT`, 0 to 100) below this are
  /// left out. Default 0: none.
  vtkSetMacro(MinimumConfidence, double);
  vtkGetMacro(MinimumConfidence, double);
  ///@}

  vtkTable* GetProfile();
  vtkTable* GetPoreTable();
  vtkPolyData* GetBottlenecks();
  vtkTable* GetLiningResidues();
  vtkPolyData* GetTubes();
  vtkPolyData* GetLiningAtoms();

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkPoreProfile();
  ~vtkPoreProfile() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPoreProfile(const vtkPoreProfile&) = delete;
  void operator=(const vtkPoreProfile&) = delete;

  void Compute(vtkPointSet* atoms, vtkInformationVector* outputs);

  int RadiusTable = OfInput;
  int Mode = Automatic;
  double Point1[3] = { 0.0, 0.0, 0.0 };
  double Point2[3] = { 0.0, 0.0, 0.0 };
  double Point[3] = { 0.0, 0.0, 0.0 };
  double Direction[3] = { 0.0, 0.0, 1.0 };
  isthmus::PoreOptions Parameters;
  bool IncludeHydrogens = true;
  bool IncludeIons = false;
  bool IncludeLigands = false;
  double MinimumConfidence = 0.0;
};

#endif
