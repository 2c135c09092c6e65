/**
 * @class   vtkPoreProfile
 * @brief   the radius along pores and channels of a molecule, and what lines them
 *
 * Input: atoms, points with the array `Radius` (input array 0), as vtkMacromoleculeReader makes
 * them. Where it gives names, water, ions and ligands are dropped (the field array `Notes` says
 * what); hydrogens stay, unlike in vtkMolecularPockets.
 *
 * Or a closed surface (polygons without a radius), of a map say, as vtkMapSurface makes it: its
 * points are taken as atoms of radius 0, so that radii are too large by some h^2 / 6r at edges of
 * h. Channels narrower than its longest edge cannot be distinguished from the gaps between points
 * and are left out.
 *
 * Mode Automatic finds the channels that run through; TwoPoints takes the pore from Point1 to
 * Point2; PointAndDirection takes planes across Direction, both ways from Point, as HOLE does.
 * PoreProfile.h and PoreChannels.h have the definitions.
 *
 * - **Output 0**, vtkPolyData: a polyline for each pore, through the centres of the largest balls.
 *   Point arrays `Radius`, `ArcLength` (angstrom), `NearestAtom` (point of the input),
 *   `NearestResidue`, `WidthClass` (0: narrower than water, radius below 1.15; 1: room for one
 *   water; 2: for two, from 2.30, HOLE's colours), `PoreId`; cell array `PoreId`. 1 is the longest.
 * - **Output 1**, vtkTable: the same samples as rows, with X, Y, Z, for a chart.
 * - **Output 2**, vtkTable: a row for each pore: `PoreId`, `Radius` (the least), `Length`, `Span`,
 *   `Bottlenecks`, `BottleneckX`, `BottleneckY`, `BottleneckZ`.
 * - **Output 3**, vtkPolyData: bottlenecks, local minima of the radius: points with `PoreId`,
 *   `Rank` (1: the narrowest), `Radius`, `ArcLength`, `NearestAtom`, `NearestResidue`, `Residues`
 *   (those that touch the ball there, within 0.5 angstrom).
 * - **Output 4**, vtkTable: lining residues: `PoreId` and the columns of vtkMolecularPockets.
 * - **Output 5**, vtkPolyData: tubes of the pores' radii with `Radius`, `WidthClass`, `PoreId`.
 * - **Output 6**, vtkPolyData: the lining residues whole, with their bonds, the input's point
 *   arrays and `PoreId`.
 *
 * **Errors** (message, empty outputs): no radii, radii, points or options out of range, no way
 * between the points. No pore that runs through is none.
 *
 * **Cost.** About 1 ms a plane. Bitwise the same on any number of threads.
 */
#ifndef vtkPoreProfile_h
#define vtkPoreProfile_h

#include "vtkIsthmusFiltersPocketsModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the properties

class vtkPointSet;
class vtkTable;

class VTKISTHMUSFILTERSPOCKETS_EXPORT vtkPoreProfile : public vtkPolyDataAlgorithm
{
public:
  static vtkPoreProfile* New();
  vtkTypeMacro(vtkPoreProfile, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Modes
  {
    Automatic = 0,
    TwoPoints = 1,
    PointAndDirection = 2
  };

  ///@{
  /// Which pores. Default: Automatic.
  vtkSetClampMacro(Mode, int, Automatic, PointAndDirection);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /// The ends of the pore, angstrom, for TwoPoints. Default: the origin.
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  ///@}

  ///@{
  /// A place in the pore (angstrom) and the way along it, for PointAndDirection. Default: origin,
  /// z.
  vtkSetVector3Macro(Point, double);
  vtkGetVector3Macro(Point, double);
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /// Radius at which a pore ends. Default: 5 angstrom.
  vtkSetMacro(EndRadius, double);
  vtkGetMacro(EndRadius, double);
  ///@}

  ///@{
  /// Distance of the planes. Default: 0.25 angstrom.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// Least radius of channels, for Automatic. Default: 1 angstrom.
  vtkSetMacro(MinimumRadius, double);
  vtkGetMacro(MinimumRadius, double);
  ///@}

  ///@{
  /// Least distance of a channel's ends, for Automatic. Default: 20 angstrom.
  vtkSetMacro(MinimumSpan, double);
  vtkGetMacro(MinimumSpan, double);
  ///@}

  ///@{
  /// How many channels at most, for Automatic. Default: 20.
  vtkSetMacro(MaximumPores, int);
  vtkGetMacro(MaximumPores, int);
  ///@}

  ///@{
  /// How far the way may be from the straight line, for TwoPoints. Default: 10 angstrom.
  vtkSetMacro(MaximumOffset, double);
  vtkGetMacro(MaximumOffset, double);
  ///@}

  ///@{
  /// What counts as part of the molecule beside its chains. Default: hydrogens.
  vtkSetMacro(KeepHydrogens, bool);
  vtkGetMacro(KeepHydrogens, bool);
  vtkBooleanMacro(KeepHydrogens, bool);
  vtkSetMacro(KeepIons, bool);
  vtkGetMacro(KeepIons, bool);
  vtkBooleanMacro(KeepIons, bool);
  vtkSetMacro(KeepLigands, bool);
  vtkGetMacro(KeepLigands, bool);
  vtkBooleanMacro(KeepLigands, bool);
  ///@}

  vtkTable* GetProfile();
  vtkTable* GetPoreTable();
  vtkPolyData* GetBottlenecks();
  vtkTable* GetLiningResidues();
  vtkPolyData* GetTubes();
  vtkPolyData* GetLiningAtoms();

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

  int Mode = Automatic;
  double Point1[3] = { 0.0, 0.0, 0.0 };
  double Point2[3] = { 0.0, 0.0, 0.0 };
  double Point[3] = { 0.0, 0.0, 0.0 };
  double Direction[3] = { 0.0, 0.0, 1.0 };
  double EndRadius = 5.0;
  double Spacing = 0.25;
  double MinimumRadius = 1.0;
  double MinimumSpan = 20.0;
  int MaximumPores = 20;
  double MaximumOffset = 10.0;
  bool KeepHydrogens = true;
  bool KeepIons = false;
  bool KeepLigands = false;
};

#endif
