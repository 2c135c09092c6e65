/**
 * @file IonTransportInput.h
 * @brief What vtkIonTransport is given, brought to the grid.
 */
#ifndef isthmus_IonTransportInput_h
#define isthmus_IonTransportInput_h

#include "Core/Progress.h"
#include "Solvation/TransportGrid.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace isthmus
{

/// Gives each species its name from a list between blanks, commas or semicolons, or `Ion` and its
/// number.
/// @throws std::invalid_argument for a name that two have.
void NameSpecies(const std::string& names, std::vector<TransportSpecies>& species);

/// The distance from each node to closed triangles, angstrom, negative within, cut at 4.5 spacings.
/// Parallel.
/// @throws std::invalid_argument where they are not closed, Cancelled.
std::vector<float> DistanceToClosed(
  const TransportDomain& domain, vtkPolyData* surface, const ProgressCallback& progress = {});

}

#endif
