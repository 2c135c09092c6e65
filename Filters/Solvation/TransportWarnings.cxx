#include "Solvation/TransportWarnings.h"

#include "Core/RangeChecks.h"

#include <algorithm>

namespace isthmus
{
namespace
{

std::string Narrow(const ChannelPassage& passage)
{
  const Point3& at = passage.Bottleneck;
  return "At (" + FormatNumber(at[0]) + ", " + FormatNumber(at[1]) + ", " + FormatNumber(at[2]) +
    ") the channel has a radius of " + FormatNumber(passage.Radius) +
    " angstrom, less than a Spacing: the current hangs on how the nodes lie there. Choose a "
    "smaller "
    "Spacing.";
}

std::string NotConverged(const TransportPoint& point, double tolerance)
{
  const IonTransportReport& report = point.Report;
  const std::string start = "At " + FormatNumber(point.Voltage) + " mV ";
  if (report.Changes.back() > tolerance)
  {
    return start + "the potential still changed by " + FormatNumber(report.Changes.back()) +
      " kT/e after " + std::to_string(report.Iterations) +
      " iterations. The state that changed least is kept, with Converged 0: choose more "
      "MaximumIterations or a larger Tolerance.";
  }
  return start + "a part of " + FormatNumber(report.Imbalance) +
    " of a current is lost on its way: the equations of the ions could not be solved. What there "
    "is "
    "is kept, with Converged 0: choose a smaller Spacing or Voltage, or look for charges that "
    "touch "
    "the water.";
}

std::string NotAtRest(const MovingChannel& moving)
{
  return "The surface has not come to rest after " + std::to_string(moving.GetUpdates().size()) +
    " updates: currents or water still changed by a part of " + FormatNumber(moving.LastChange()) +
    ". Update " + std::to_string(moving.GetShown() + 1) +
    ", which changed least, is kept, with Rests 0: choose more MaximumUpdates, a larger "
    "UpdateTolerance, or a smaller FieldRelaxation.";
}

}

std::vector<std::string> TransportWarnings(
  const AtomBalls& atoms, ChannelSolution& channel, const std::vector<TransportPoint>& points)
{
  std::vector<std::string> sentences;
  if (atoms.WithoutRadius > 0)
  {
    sentences.push_back(std::to_string(atoms.WithoutRadius) + " of " +
      std::to_string(atoms.NumberOfAtoms) + " atoms have no radius and were left out.");
  }
  const IonTransportParameters& parameters = channel.Get().GetParameters();
  if (channel.GetPassage().Radius < parameters.Spacing)
  {
    sentences.push_back(Narrow(channel.GetPassage()));
  }
  const auto left = std::find_if(points.begin(), points.end(),
    [](const TransportPoint& point) { return !point.Report.Converged; });
  if (left != points.end())
  {
    sentences.push_back(NotConverged(*left, parameters.Tolerance));
  }
  if (channel.GetMoving() && !channel.GetMoving()->Rests())
  {
    sentences.push_back(NotAtRest(*channel.GetMoving()));
  }
  return sentences;
}

}
