/**
 * @file IonTransportOutput.h
 * @brief Converts ion transport to VTK data: image, currents by section, updates of the surface.
 */
#ifndef isthmus_IonTransportOutput_h
#define isthmus_IonTransportOutput_h

#include "Solvation/MovingChannel.h"
#include "Solvation/TransportCurrents.h"

class vtkImageData;
class vtkTable;

namespace isthmus
{

/// Extent, origin, spacing and direction of the domain's grid.
void SetImageGeometry(const TransportDomain& domain, vtkImageData* image);

/// The box along the coordinate axes that the image of a domain shows, since filters of VTK and
/// ParaView, contours among them, ignore directions of images.
TransportDomain ImageBox(const TransportDomain& domain);

/// Potential (active), Concentration_NAME and Flux_NAME of each species, CurrentDensity,
/// SignedDistance, in ImageBox(), interpolated trilinearly if the grid is turned. Parallel. @throws
/// std::runtime_error if a number exceeds the range of float, which absurd charges can cause;
/// Cancelled.
void FillTransportImage(
  const PoissonNernstPlanck& solution, vtkImageData* image, const ProgressCallback& progress = {});

/// Field data: voltage, currents, accuracy, bottleneck.
void FillTransportNumbers(const PoissonNernstPlanck& solution, const CurrentProfile& profile,
  double currentError, const ChannelPassage& passage, vtkImageData* image);

/// A row for each section: Along, Current_NAME, Current.
void FillSections(
  const CurrentProfile& profile, const std::vector<TransportSpecies>& species, vtkTable* table);

/// Of a moving surface: a row for each update, and field data: ShownUpdate, and Converged, which is
/// 1 only if the surface has converged as well.
void FillMotion(const MovingChannel& moving, const std::vector<TransportSpecies>& species,
  vtkImageData* image, vtkTable* table);

}

#endif
