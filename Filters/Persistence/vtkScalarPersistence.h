/**
 * @class   vtkScalarPersistence
 * @brief   components, tunnels and cavities of a volume: between which levels each exists
 *
 * Input: vtkImageData with one number per node (float, double or any integer). As the level rises
 * (with Superlevel, falls), the set of nodes below (above) it grows. The filter computes the levels
 * at which each component, tunnel and cavity of the set appears and disappears, over Z/2.
 *
 * **Connectivity.** The V-construction: the nodes are the points of the complex, and an edge,
 * face or cube of the grid is in it as soon as all of its corners are. Thus nodes of the object are
 * connected along the axes (6 neighbours), and nodes of the background also across edges and
 * corners (26). The box itself is solid: a tunnel or cavity that would be closed only by the space
 * beyond the border is not found, so leave a margin around an object.
 *
 * Outputs, whose arrays OutputArrayTable() lists:
 *  - 0, *Betti Curves* (vtkTable) at NumberOfLevels levels: of all classes and of those listed, the
 *    Euler number, and the exact integrals of the curves;
 *  - 1, *Persistence Diagram* (vtkTable): one row for each listed class, the longest first;
 *  - 2, *Saddles and Extrema* (vtkPolyData): the nodes where classes begin and end. Point i is the
 *    saddle of row i of the diagram (the extremum, for the class that never dies), so that a
 *    selection link from the diagram shows it; the other ends follow;
 *  - 3, *Cycles* (vtkPolyData; with Cycles on): a short closed polyline around each listed tunnel,
 *    on the edges of the grid;
 *  - 4, *Simplified* (vtkImageData; with Simplify on): the input with the minima and maxima of the
 *    dropped classes flattened (as TTK's topological simplification does).
 *
 * **What is listed.** The listed classes are those with an absolute value of Death - Birth of at
 * least MinimumPersistence (of the part within Range if that is given), and always the class that
 * never dies. A class that begins and ends at the same value is never listed. FeatureId numbers all
 * classes from the longest to the shortest, so it does not depend on the threshold.
 *
 * **Errors** (one message, empty outputs): a value that is not a number, with its position; an
 * invalid range or persistence; too little memory for the volume, with the memory needed and what
 * to do, before the work begins. An empty image gives empty outputs.
 *
 * **Cost.** Nearly linear for maps; memory for each node in addition to the input: 5 bytes, and
 * 100 for each critical cell: 4-20 bytes for maps, 80 for white noise. Changing MinimumPersistence
 * only looks up cached results. The result is the same on any number of threads. On several MPI
 * ranks, each rank requests the whole volume; the first one computes and holds the tables and
 * points. (Each rank computes the simplified volume and keeps its part.)
 *
 * Method and sources: CubicalPersistence.h, ScalarSimplification.h, CubicalCycles.h.
 */
#ifndef vtkScalarPersistence_h
#define vtkScalarPersistence_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Persistence/ScalarFeatures.h"
#include "vtkIsthmusFiltersPersistenceModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

#include <memory> // for the cache
#include <vector> // for the table of output arrays

class vtkImageData;
class vtkPolyData;
class vtkTable;

namespace isthmus
{
class PersistenceCache;
}

class VTKISTHMUSFILTERSPERSISTENCE_EXPORT vtkScalarPersistence : public vtkTableAlgorithm
{
public:
  static vtkScalarPersistence* New();
  vtkTypeMacro(vtkScalarPersistence, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Let the set grow from the highest value down (density maps) instead of from the lowest value
  /// up. Default off.
  ISTHMUS_PARAMETER_SWITCH(Superlevel);
  ///@}

  ///@{
  /// Smallest persistence of the listed classes, in PersistenceUnit; at least 0. Default 0.
  ISTHMUS_PARAMETER(MinimumPersistence, double);
  ///@}

  enum PersistenceUnits
  {
    Absolute = 0,
    StandardDeviations = 1,
    LargestGap = 2
  };

  ///@{
  /// MinimumPersistence is a difference of values (Absolute, default) or a number of standard
  /// deviations of the volume. With LargestGap it is not used; the classes above the widest gap are
  /// kept.
  ISTHMUS_PARAMETER(PersistenceUnit, int);
  ///@}

  ///@{
  /// Number of rows of the Betti curves, from 2 to a million. Default 256.
  vtkSetMacro(NumberOfLevels, int);
  vtkGetMacro(NumberOfLevels, int);
  ///@}

  ///@{
  /// Make output 3. Default off.
  vtkSetMacro(Cycles, bool);
  vtkGetMacro(Cycles, bool);
  vtkBooleanMacro(Cycles, bool);
  ///@}

  ///@{
  /// Maximum number of tunnels with a cycle; those with the largest persistence are chosen. At
  /// least 1. Default 100.
  vtkSetMacro(MaximumNumberOfCycles, int);
  vtkGetMacro(MaximumNumberOfCycles, int);
  ///@}

  ///@{
  /// Make output 4. Default off.
  vtkSetMacro(Simplify, bool);
  vtkGetMacro(Simplify, bool);
  vtkBooleanMacro(Simplify, bool);
  ///@}

  ///@{
  /// The outputs, by name.
  vtkTable* GetBettiCurves();
  vtkTable* GetDiagram();
  vtkPolyData* GetSaddles();
  vtkPolyData* GetCycleLines();
  vtkImageData* GetSimplified();
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// The levels that are considered: classes without a part in Range are dropped, and persistence
  /// is the length of that part. Automatic unless given: all levels.
  ISTHMUS_AUTOMATIC_RANGE_UNLESS_GIVEN(Range);

protected:
  vtkScalarPersistence();
  ~vtkScalarPersistence() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkScalarPersistence(const vtkScalarPersistence&) = delete;
  void operator=(const vtkScalarPersistence&) = delete;

  class vtkInternals; ///< data of one execution
  void CheckParameters() const;
  void FindPairs(vtkInternals& work);
  void FillTables(const vtkInternals& work, vtkInformationVector* outputVector);
  void FillSimplified(const vtkInternals& work, vtkInformationVector* outputVector);

  isthmus::FeatureParameters Parameters; ///< without Range
  int NumberOfLevels = 256;
  bool Cycles = false;
  int MaximumNumberOfCycles = 100;
  bool Simplify = false;
  std::unique_ptr<isthmus::PersistenceCache> Cache;
};

#endif
