/**
 * @class vtkMapChokingLoops
 * @brief The choking loops of a density map: its surface at a level, then vtkChokingLoops.
 *
 * Input: vtkImageData with one-component point scalars of any number type, any spacing, origin and
 * direction. Values that are not numbers count as outside.
 *
 * Outputs 0 to 3 are those of vtkChokingLoops; output 4 is the surface, as vtkMapSurface makes it
 * at the same level: closed half a cell beyond the map where the level set leaves it. Radii are in
 * the unit of the map, angstrom. Field data of output 0 has the `Level` used.
 *
 * The level is automatic unless one is given, as in vtkMapSurface: the one recommended by the
 * depositors, or else one that separates the molecule from its surroundings. The contour and the
 * analysis are cached: changes of thresholds, side and shortening do not repeat them.
 *
 * Errors (message and empty outputs): those of vtkChokingLoops; a level with nothing inside. Cost:
 * that of vtkMapSurface and vtkChokingLoops. With several MPI ranks, the first one does all the
 * work.
 *
 * @sa vtkMapSurface vtkChokingLoops vtkMapHandles
 */
#ifndef vtkMapChokingLoops_h
#define vtkMapChokingLoops_h

#include "Core/Deprecation.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the analysis and the surface

#include <limits>
#include <memory>
#include <string>

class vtkChokingLoops;
class vtkDataArray;
class vtkImageData;

namespace isthmus
{
class AutomaticLevel;
}

class VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT vtkMapChokingLoops : public vtkPolyDataAlgorithm
{
public:
  static vtkMapChokingLoops* New();
  vtkTypeMacro(vtkMapChokingLoops, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  // Values of the properties, as in vtkChokingLoops.
  enum SideType
  {
    Inside,
    Outside,
    Both
  };
  enum ShorteningType
  {
    None,
    Rounds,
    Geodesic
  };
  enum ThresholdModeType
  {
    Given,
    LargestGap
  };
  enum UnitType
  {
    Percent,
    Absolute
  };
  enum LoopOrderType
  {
    ByRadius,
    ByLength
  };
  enum FiltrationType
  {
    Delaunay ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use vtkChokingLoops::Delaunay"),
    TetrahedralMesh ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use vtkChokingLoops::TetrahedralMesh")
  };
  enum MorseFunctionType
  {
    ClosestPoint ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use vtkChokingLoops::ClosestPoint"),
    EdgePaths ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use vtkChokingLoops::EdgePaths"),
    GridDistance ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use vtkChokingLoops::GridDistance"),
    PointArray ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use vtkChokingLoops::PointArray"),
    FastMarching ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use vtkChokingLoops::FastMarching")
  };

  ///@{
  /// Value of the level set, in the unit of the scalars. Setting a finite one switches
  /// AutomaticLevel off. Default 0.
  void SetLevel(double level);
  vtkGetMacro(Level, double);
  ///@}

  /// For panels, where the level always has a value. 1: the automatic level. 2, the setting of a
  /// new panel: Level, unless it is ProposedLevel, or the middle of the range of the map or of one
  /// before, which is ParaView's default and therefore counts as not set. 0 and 3: always Level.
  /// State files from before 1.0 have 0.
  void SetPanelAutomaticLevel(int mode);
  /// Level as panels and state files set it: AutomaticLevel stays as it is.
  void SetPanelLevel(double level);

  ///@{
  /// The level that a panel proposes for a new filter, and which counts as not set. Default 1e300.
  vtkSetMacro(ProposedLevel, double);
  vtkGetMacro(ProposedLevel, double);
  ///@}

  ///@{
  /// Use the recommended level, or else an estimated one, instead of Level. Default on.
  void SetAutomaticLevel(bool automatic);
  vtkGetMacro(AutomaticLevel, bool);
  vtkBooleanMacro(AutomaticLevel, bool);
  ///@}

  /// The level of the last run.
  vtkGetMacro(UsedLevel, double);

  ///@{
  /// The inside is where the value is above the level (densities). Default on.
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Keep this many components of the surface, those of the largest area; 0 (default): all.
  vtkSetClampMacro(LargestComponents, int, 0, VTK_INT_MAX);
  vtkGetMacro(LargestComponents, int);
  ///@}

  ///@{
  /// Parameters of vtkChokingLoops, documented there, with the same defaults.
  void SetSide(int value);
  int GetSide();
  void SetMaximumRadius(double value);
  double GetMaximumRadius();
  void SetMaximumRadiusUnit(int value);
  int GetMaximumRadiusUnit();
  void SetMinimumPersistence(double value);
  double GetMinimumPersistence();
  void SetMinimumPersistenceUnit(int value);
  int GetMinimumPersistenceUnit();
  void SetThresholdMode(int value);
  int GetThresholdMode();
  void SetMaximumNumberOfLoops(int value);
  int GetMaximumNumberOfLoops();
  void SetTrustedOnly(bool value);
  bool GetTrustedOnly();
  vtkBooleanMacro(TrustedOnly, bool);
  void SetMaximumLength(double value);
  double GetMaximumLength();
  void SetMaximumReach(double value);
  double GetMaximumReach();
  void SetLoopOrder(int value);
  int GetLoopOrder();
  void SetAlwaysReportHandles(bool value);
  bool GetAlwaysReportHandles();
  vtkBooleanMacro(AlwaysReportHandles, bool);
  void SetSampleSpacing(double value);
  double GetSampleSpacing();
  void SetShortening(int value);
  int GetShortening();
  void SetShorteningRounds(int value);
  int GetShorteningRounds();
  void SetAllowSelfIntersections(bool value);
  bool GetAllowSelfIntersections();
  vtkBooleanMacro(AllowSelfIntersections, bool);
  void SetMemoryLimit(int value);
  int GetMemoryLimit();
  ///@}

  ///@{
  /// Deprecated, removed in 1.1.0.
  ISTHMUS_DEPRECATED("1.0.0", "the surface of a map is closed")
  void SetCapHoles(bool value);
  ISTHMUS_DEPRECATED("1.0.0", "the surface of a map is closed")
  bool GetCapHoles();
  ISTHMUS_DEPRECATED("1.0.0", "the surface of a map is closed")
  void CapHolesOn();
  ISTHMUS_DEPRECATED("1.0.0", "the surface of a map is closed")
  void CapHolesOff();
  ISTHMUS_DEPRECATED("1.0.0", "the filtration of a map's surface is Delaunay")
  void SetFiltration(int value);
  ISTHMUS_DEPRECATED("1.0.0", "the filtration of a map's surface is Delaunay")
  int GetFiltration();
  ISTHMUS_DEPRECATED("1.0.0", "it needs a tetrahedral mesh: use vtkChokingLoops")
  void SetMorseFunction(int value);
  ISTHMUS_DEPRECATED("1.0.0", "it needs a tetrahedral mesh: use vtkChokingLoops")
  int GetMorseFunction();
  ISTHMUS_DEPRECATED("1.0.0", "it needs a tetrahedral mesh: use vtkChokingLoops")
  void SetMorseArrayName(const std::string& value);
  ISTHMUS_DEPRECATED("1.0.0", "it needs a tetrahedral mesh: use vtkChokingLoops")
  std::string GetMorseArrayName();
  ISTHMUS_DEPRECATED("1.0.0", "use SetMaximumRadius")
  void SetMaximumDistance(double radius) { this->SetMaximumRadius(radius); }
  ISTHMUS_DEPRECATED("1.0.0", "use GetMaximumRadius")
  double GetMaximumDistance() { return this->GetMaximumRadius(); }
  ISTHMUS_DEPRECATED("1.0.0", "use SetMaximumRadiusUnit")
  void SetMaximumDistanceUnit(int unit) { this->SetMaximumRadiusUnit(unit); }
  ISTHMUS_DEPRECATED("1.0.0", "use GetMaximumRadiusUnit")
  int GetMaximumDistanceUnit() { return this->GetMaximumRadiusUnit(); }
  ///@}

  /// As in vtkChokingLoops.
  double* GetStageTimes() VTK_SIZEHINT(5);

protected:
  vtkMapChokingLoops();
  ~vtkMapChokingLoops() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkMapChokingLoops(const vtkMapChokingLoops&) = delete;
  void operator=(const vtkMapChokingLoops&) = delete;

  double ChooseLevel(vtkImageData* image, vtkDataArray* scalars);
  void Contour(vtkImageData* image);
  void FindLoops(vtkInformationVector* output);

  double Level = 0.0;
  bool AutomaticLevel = true;
  int PanelMode = 1; ///< of SetPanelAutomaticLevel()
  double ProposedLevel = 1e300;
  double FormerMiddle = std::numeric_limits<double>::quiet_NaN(); ///< a Level that was IsMiddle()
  double UsedLevel = 0.0;
  bool InsideIsHigher = true;
  int LargestComponents = 0;

  vtkSmartPointer<vtkChokingLoops> Loops;
  std::unique_ptr<isthmus::AutomaticLevel> LevelOfMap;
  struct Key;
  std::unique_ptr<Key> MadeOf; ///< the surface of the last run
  vtkSmartPointer<vtkPolyData> Surface;
};

#endif
