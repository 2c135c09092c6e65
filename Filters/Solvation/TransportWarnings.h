/**
 * @file TransportWarnings.h
 * @brief What the user of ion transport is warned of, as sentences.
 */
#ifndef isthmus_TransportWarnings_h
#define isthmus_TransportWarnings_h

#include "Atoms/AtomBalls.h"
#include "Solvation/ChannelSolution.h"
#include "Solvation/TransportSweep.h"

#include <string>
#include <vector>

namespace isthmus
{

/// Atoms that were left out, a channel narrower than a spacing, the first point that has not
/// converged or has lost ions on their way, a surface that has not come to rest.
std::vector<std::string> TransportWarnings(
  const AtomBalls& atoms, ChannelSolution& channel, const std::vector<TransportPoint>& points);

}

#endif
