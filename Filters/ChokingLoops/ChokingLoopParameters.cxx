#include "ChokingLoops/ChokingLoopParameters.h"

#include "Core/RangeChecks.h"

#include <limits>

namespace isthmus
{
namespace
{

constexpr double LargestCount = std::numeric_limits<int>::max();

}

void Check(const ChokingLoopParameters& parameters)
{
  RequireRange("SampleSpacing", parameters.SampleSpacing, 0.0, LargestLength,
    "It is a length, or 0 to choose it automatically.");
  RequireRange("Accuracy", parameters.Accuracy, 0.01, 100.0, "It is a percentage of the radius.");
  RequireRange("MemoryLimit", parameters.MemoryLimit, 0.0, LargestCount, "It is in MiB.");
}

void Check(const FeatureSelection& selection)
{
  RequireChoice("Side", selection.Side, SideSelection::Both);
  RequireRange("MaximumRadius", selection.MaximumRadius, 0.0, LargestLength);
  RequireChoice("MaximumRadiusUnit", selection.MaximumRadiusUnit, LengthUnit::Absolute);
  RequireRange("MinimumPersistence", selection.MinimumPersistence, 0.0, LargestLength);
  RequireChoice("MinimumPersistenceUnit", selection.MinimumPersistenceUnit, LengthUnit::Absolute);
  RequireChoice("ThresholdMode", selection.ThresholdMode, ThresholdMode::LargestGap);
  RequireRange(
    "MaximumNumberOfLoops", selection.MaximumNumberOfLoops, 0.0, LargestCount, "0: no limit.");
}

void Check(const LoopLimits& limits)
{
  RequireRange("MaximumLength", limits.MaximumLength, 0.0, LargestLength, "0: no limit.");
  RequireRange("MaximumReach", limits.MaximumReach, 0.0, LargestLength, "0: no limit.");
  RequireChoice("LoopOrder", limits.LoopOrder, LoopOrder::ByLength);
}

void Check(const LoopSearchParameters& parameters)
{
  Check(static_cast<const ChokingLoopParameters&>(parameters));
  Check(static_cast<const FeatureSelection&>(parameters));
  Check(static_cast<const LoopLimits&>(parameters));
  RequireChoice("Filtration", parameters.Filtration, LoopFiltration::TetrahedralMesh);
  RequireChoice("MorseFunction", parameters.MorseFunction, MeshFunction::FastMarching);
  RequireChoice("Shortening", parameters.Shortening, ShorteningMode::Geodesic);
  RequireRange("ShorteningRounds", parameters.ShorteningRounds, 1, 1000);
  RequireChoice("MembraneMethod", parameters.MembraneMethod, MembraneMethod::Greedy);
}

void Check(const LoopShorteningParameters& parameters)
{
  RequireRange("MaximumRounds", parameters.MaximumRounds, 1, 100000);
  RequireRange("Tolerance", parameters.Tolerance, 1e-12, 1.0, "It is a fraction of the length.");
}

void Check(const HandleFillingParameters& parameters)
{
  Check(static_cast<const ChokingLoopParameters&>(parameters));
  RequireAbove("FillHandlesBelow", parameters.FillHandlesBelow, 0.0, LargestLength,
    "It is the radius below which handles and tunnels are removed.");
  RequireChoice("Side", parameters.Side, SideSelection::Both);
  RequireAbove(
    "Thickness", parameters.Thickness, 0.0, 1.0, "It is in radii of the handle or tunnel.");
}

void Check(const OffsetSurfaceParameters& parameters)
{
  RequireAbove(
    "Distance", parameters.Distance, 0.0, LargestLength, "It is the distance from the surface.");
  RequireChoice("Side", parameters.Side, SideSelection::Both);
  RequireRange("Resolution", parameters.Resolution, 8, 1024,
    "It is the number of cells along the longest side.");
}

void Check(const SupportParameters& parameters)
{
  RequireRange("NumberOfResamples", parameters.NumberOfResamples, 1, 10000);
  RequireRange("Seed", parameters.Seed, 0.0, LargestCount);
}

}
