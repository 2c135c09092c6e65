/**
 * @class   vtkMapHandles
 * @brief   bridges and windows of a map, the levels at which each exists, and a stable level
 *
 * Input: vtkImageData with one number per node, a density map. As the contour level falls, parts of
 * the object meet at *bridges* (1-saddles) and what is open across closes at *windows* (2-saddles).
 * Persistence says over which levels each of them is real, and so which level to choose.
 *
 * Outputs:
 *  - 0, *Bridges* and 1, *Windows* (vtkPolyData, points): `FeatureId` (of the class, as in
 *    vtkScalarPersistence with the same settings), `Dimension`, `Birth`, `Death`, `Persistence`,
 *    `Level` (the saddle's value), `From`, `To` (levels between which it exists, within the range),
 *    `IsThere` (1: at the level chosen).
 *  - 2, *Levels* (vtkTable), for a line chart: `Level`, `Beta0` ... `Beta2` of what persists, and
 *    `StableLevel`, `RecommendedLevel`: Beta1 at the row of that level, not a number elsewhere, so
 *    that each is drawn as one mark.
 *  - 3, *Stable Intervals* (vtkTable): `From`, `To`, `Middle`, `Length`, `Beta0` ... `Beta2`: the
 *    runs of levels at which nothing that persists appears or disappears, the longest first. Its
 *    first Middle is the stable level.
 *  - 4, *Contour* (vtkPolyData) at the level chosen, ready for Choking Loops.
 *  - 5, *Loops* and 6, *Choke Points* of it (with Loops on), by vtkChokingLoops with its default
 *    settings.
 *
 * Field data of all: `StableLevel`, `ChosenLevel`, and `RecommendedLevel` where one is given.
 *
 * **Range.** Density below the noise is no persistence, so bars are clipped to Range; without one
 * it extends from the mean of the map (the surroundings of the molecule) to its maximum.
 *
 * **Report saddles, not bars.** Equal narrowings of a symmetric map come in groups of saddles at
 * nearly one level, but the elder rule hands them to different dimensions: one of n joins the last
 * component, the others close tunnels.
 *
 * **Errors** (one message, empty outputs): a value that is not a number; an invalid range
 * or persistence; a map without a level to choose. Cost: that of vtkScalarPersistence, a contour,
 * and with Loops that of vtkChokingLoops. On several MPI ranks the first one does everything.
 *
 * Method: MapHandles.h, CubicalPersistence.h.
 */
#ifndef vtkMapHandles_h
#define vtkMapHandles_h

#include "Core/Deprecation.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <limits> // for NaN
#include <memory> // for the cache

namespace isthmus
{
class PersistenceCache;
}

class VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT vtkMapHandles : public vtkPolyDataAlgorithm
{
public:
  static vtkMapHandles* New();
  vtkTypeMacro(vtkMapHandles, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The object is where the map is above the level (densities). Default on.
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ISTHMUS_DEPRECATED("1.0.0", "use SetInsideIsHigher")
  void SetSuperlevel(bool higher) { this->SetInsideIsHigher(higher); }
  ISTHMUS_DEPRECATED("1.0.0", "use GetInsideIsHigher")
  bool GetSuperlevel() { return this->GetInsideIsHigher(); }
  ISTHMUS_DEPRECATED("1.0.0", "use InsideIsHigherOn")
  void SuperlevelOn() { this->InsideIsHigherOn(); }
  ISTHMUS_DEPRECATED("1.0.0", "use InsideIsHigherOff")
  void SuperlevelOff() { this->InsideIsHigherOff(); }
  ///@}

  ///@{
  /// Shortest interval of levels that counts, in standard deviations of the map; at least 0.
  /// Default 0.5.
  vtkSetMacro(MinimumPersistence, double);
  vtkGetMacro(MinimumPersistence, double);
  ///@}

  ///@{
  /// Look only at levels within Range. Default off: from the mean to the maximum (InsideIsHigher
  /// off: from the minimum to the mean).
  vtkSetMacro(UseRange, bool);
  vtkGetMacro(UseRange, bool);
  vtkBooleanMacro(UseRange, bool);
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

  ///@{
  /// Take the stable level (default) or Level for contour and loops. The stable level is proposed
  /// from the topology of the map over all levels; it is not the automatic level of vtkMapSurface
  /// and vtkMapChokingLoops, which is recommended by the depositors or separates values. Setting
  /// Level does not switch UseStableLevel off.
  vtkSetMacro(UseStableLevel, bool);
  vtkGetMacro(UseStableLevel, bool);
  vtkBooleanMacro(UseStableLevel, bool);
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /// The level that the map's authors recommend (EMDB), for comparison. Default: none.
  vtkSetMacro(UseRecommendedLevel, bool);
  vtkGetMacro(UseRecommendedLevel, bool);
  vtkBooleanMacro(UseRecommendedLevel, bool);
  vtkSetMacro(RecommendedLevel, double);
  vtkGetMacro(RecommendedLevel, double);
  ///@}

  ///@{
  /// Rows of the table of levels, from 2 to a million. Default 256.
  vtkSetMacro(NumberOfLevels, int);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /// Run the choking loops of the contour. Default off: it takes seconds to minutes.
  vtkSetMacro(Loops, bool);
  vtkGetMacro(Loops, bool);
  vtkBooleanMacro(Loops, bool);
  ///@}

  /// The stable level of the last run; NaN before.
  vtkGetMacro(StableLevel, double);

protected:
  vtkMapHandles();
  ~vtkMapHandles() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMapHandles(const vtkMapHandles&) = delete;
  void operator=(const vtkMapHandles&) = delete;

  struct Work;
  void CheckParameters() const;
  void FindFeatures(Work& work);
  double ChooseLevel(const Work& work);
  void FillTables(const Work& work, vtkInformationVector* outputVector);
  void FillSurfaces(const Work& work, vtkInformationVector* outputVector);

  bool InsideIsHigher = true;
  double MinimumPersistence = 0.5;
  bool UseRange = false;
  double Range[2] = { 0.0, 1.0 };
  bool UseStableLevel = true;
  double Level = 0.0;
  bool UseRecommendedLevel = false;
  double RecommendedLevel = 0.0;
  int NumberOfLevels = 256;
  bool Loops = false;
  double StableLevel = std::numeric_limits<double>::quiet_NaN();
  std::unique_ptr<isthmus::PersistenceCache> Last; ///< kept for the same input
};

#endif
