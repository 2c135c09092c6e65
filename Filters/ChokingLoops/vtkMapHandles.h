/**
 * @class   vtkMapHandles
 * @brief   Finds bridges and windows of a map, the levels at which each exists, and a stable level.
 *
 * Input: vtkImageData with one number per node, a density map. As the contour level falls, parts of
 * the object meet at *bridges* (1-saddles) and openings through the object close at *windows*
 * (2-saddles). Persistence shows over which range of levels each of them exists, and so helps to
 * choose a level.
 *
 * With a second half map as input 1, the map is the mean of both halves, and each handle has a
 * p-value (see *Half maps*).
 *
 * Outputs, whose arrays OutputArrayTable() lists:
 *  - 0, *Bridges* and 1, *Windows* (vtkPolyData, points);
 *  - 2, *Levels* (vtkTable), for a line chart: Betti numbers of the persistent features;
 *  - 3, *Stable Intervals* (vtkTable): the intervals of levels in which no persistent feature
 *    appears or disappears, the longest first. Its middle is the stable level.
 *  - 4, *Contour* (vtkPolyData) at the chosen level, ready for Choking Loops.
 *  - 5, *Loops* and 6, *Choke Points* of it (with Loops on), by vtkChokingLoops with its default
 *    settings.
 *
 * **Range.** Density within the noise should not count as persistence, so bars are clipped to
 * Range; by default this extends from the mean of the map (the surroundings of the molecule) to its
 * maximum.
 *
 * **Report saddles, not bars.** Equivalent narrowings of a symmetric map form groups of saddles at
 * nearly the same level, but the elder rule assigns them to different dimensions: one of n joins
 * the last component, the others close tunnels.
 *
 * **Half maps.** Two maps of one object from independent halves of the data, on the same nodes (to
 * 1e-4 of a spacing): half their difference is noise like that of their mean. A moving-block
 * bootstrap (Kuensch 1989) makes NumberOfResamples maps, the mean plus noise: blocks of 16^3 nodes
 * of that noise from random places, with random sign, scaled to the local deviation of the noise
 * (windows of 17 nodes). In each, the handles are found with the same range, level and threshold of
 * persistence. A handle is found again if one of its kind is within 8 nodes; of several, it is the
 * one whose interval is the most alike, and each is taken once, the longest first.
 * `PValue` is by the basic (pivotal) bootstrap: (1 + k) / (1 + resamples), where k resamples are
 * without the handle, or their noise extends its interval by as much as that extends beyond the
 * level. 1 where IsThere is 0. It is for a single handle: of 100 handles made by noise about 5 have
 * a p-value below 0.05.
 *
 * Where the half maps are equal, outside of a mask, there is no noise; maps that are equal
 * everywhere are refused. Where `HalfMapCorrelation` is below 0.1, a warning says that the maps
 * have nothing in common. Noise is taken as symmetric, and as uncorrelated beyond blocks. Cost:
 * that of vtkScalarPersistence on noisy data for each resample, and 36 bytes a node (44 with
 * scalars of type double or integers of more than 16 bits). Results are bitwise identical for the
 * same Seed.
 *
 * **Errors** (one message, empty outputs): a value that is not a number; an invalid range or
 * persistence; a map without a level to choose; too little memory for the map, with the memory
 * needed and what to do, before the work begins. Cost: that of vtkScalarPersistence, a contour, and
 * with Loops that of vtkChokingLoops. With several MPI ranks, the first one does all the work.
 *
 * Method: MapHandles.h, CubicalPersistence.h.
 */
#ifndef vtkMapHandles_h
#define vtkMapHandles_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <limits> // for NaN
#include <memory> // for the cache

class vtkAlgorithmOutput;
class vtkImageData;

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

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  ///@{
  /// The object is where the map is above the level (densities). Default on.
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Shortest interval of levels for a feature to be reported, in standard deviations of the map;
  /// at least 0. Default 0.5.
  vtkSetMacro(MinimumPersistence, double);
  vtkGetMacro(MinimumPersistence, double);
  ///@}

  ///@{
  /// Rows of the table of levels, from 2 to a million. Default 256.
  vtkSetMacro(NumberOfLevels, int);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /// The other half map: input 1, optional.
  void SetOtherHalfConnection(vtkAlgorithmOutput* half) { this->SetInputConnection(1, half); }
  void SetOtherHalfData(vtkImageData* half);
  ///@}

  ///@{
  /// Resamples of the bootstrap of two half maps, from 1 to 10000; without the other half it is not
  /// used. Default 100: the smallest p-value is 0.0099.
  ISTHMUS_PARAMETER(NumberOfResamples, int);
  ///@}

  ///@{
  /// Seed of the bootstrap, at least 0. Default 1.
  ISTHMUS_PARAMETER(Seed, int);
  ///@}

  ///@{
  /// Find the choking loops of the contour. Default off, since it takes seconds to minutes.
  vtkSetMacro(Loops, bool);
  vtkGetMacro(Loops, bool);
  vtkBooleanMacro(Loops, bool);
  ///@}

  /// The stable level of the last run; NaN before.
  vtkGetMacro(StableLevel, double);

  /// Level of the contour and its loops, in the unit of the scalars; unless it is given, the policy
  /// is that of AutomaticLevel.h. The stable level, which is derived from the topology of the map
  /// over all levels, is reported beside it.
  ISTHMUS_AUTOMATIC_UNLESS_GIVEN(Level);

  /// The levels that are considered. Automatic unless given: from the mean to the maximum
  /// (InsideIsHigher off: from the minimum to the mean).
  ISTHMUS_AUTOMATIC_RANGE_UNLESS_GIVEN(Range);

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

  class vtkInternals; ///< data of one execution
  void CheckParameters() const;
  void TakeMaps(vtkInternals& work, vtkImageData* other);
  void FindFeatures(vtkInternals& work);
  void ChooseLevel(vtkInternals& work);
  void FillTables(const vtkInternals& work, vtkInformationVector* outputVector);
  void FillSurfaces(const vtkInternals& work, vtkInformationVector* outputVector);

  bool InsideIsHigher = true;
  double MinimumPersistence = 0.5;
  int NumberOfLevels = 256;
  bool Loops = false;
  isthmus::SupportParameters Parameters; ///< of the bootstrap
  double StableLevel = std::numeric_limits<double>::quiet_NaN();
  std::unique_ptr<isthmus::PersistenceCache> Cache;
};

#endif
