/**
 * @file IonTransportOutput.h
 * @brief Ion transport as VTK data: image, currents by section, currents by voltage or salt.
 */
#ifndef isthmus_IonTransportOutput_h
#define isthmus_IonTransportOutput_h

#include "Solvation/MovingChannel.h"
#include "Solvation/TransportCurrents.h"

class vtkImageData;
class vtkTable;

namespace isthmus
{

/// Extent, origin and spacing of the domain's grid.
void SetImageGeometry(const TransportDomain& domain, vtkImageData* image);

/// Potential (active), Concentration_NAME and Flux_NAME of each species, CurrentDensity,
/// SignedDistance. Parallel. @throws std::runtime_error where a number exceeds the
/// range of float, as absurd charges make it; Cancelled.
void FillTransportImage(
  const PoissonNernstPlanck& solution, vtkImageData* image, const ProgressCallback& progress = {});

/// Field data on the accuracy of the solution.
void FillTransportNumbers(const TransportPoint& point, const std::vector<TransportSpecies>& species,
  const ChannelPassage& passage, vtkImageData* image);

/// Of a moving surface, a row an update: Update, Time, AreaChange, LumenVolume, EnergyChange,
/// OnObstacle, BottleneckRadius, Current_NAME, Current; and Rests and ShownUpdate as field data. No
/// rows and no field data for a fixed one (nullptr).
void FillMotion(const MovingChannel* moving, const std::vector<TransportSpecies>& species,
  vtkImageData* image, vtkTable* table);

/// A row a section: Along, Current_NAME, Current.
void FillSections(
  const CurrentProfile& profile, const std::vector<TransportSpecies>& species, vtkTable* table);

/// A row a point: Voltage, ConcentrationFactor, Current_NAME, Current, CurrentSpread, Converged.
void FillSweep(const std::vector<TransportPoint>& points,
  const std::vector<TransportSpecies>& species, vtkTable* table);

}

#endif
