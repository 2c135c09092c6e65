#include "Solvation/TransportSweep.h"

#include "Core/RangeChecks.h"

#include <cmath>

namespace isthmus
{
namespace
{

constexpr int MostPoints = 1000;

double Between01(int point, int points)
{
  return static_cast<double>(point) / static_cast<double>(points - 1);
}

}

std::vector<TransportPoint> SweptVoltages(double from, double to, int points)
{
  RequireRange("SweepPoints", points, 2, MostPoints, "A curve has two points or more.");
  for (const double end : { from, to })
  {
    RequireRange("SweepVoltages", end, -1000.0, 1000.0, "They are in mV.");
  }
  std::vector<TransportPoint> all(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i)
  {
    all[static_cast<std::size_t>(i)].Voltage = from + (to - from) * Between01(i, points);
  }
  return all;
}

std::vector<TransportPoint> SweptFactors(double from, double to, int points, double voltage)
{
  RequireRange("SweepPoints", points, 2, MostPoints, "A curve has two points or more.");
  for (const double end : { from, to })
  {
    RequireRange("SweepFactors", end, 1e-6, 1e3, "They multiply the baths' concentrations.");
  }
  std::vector<TransportPoint> all(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i)
  {
    all[static_cast<std::size_t>(i)].Voltage = voltage;
    all[static_cast<std::size_t>(i)].Factor = from * std::pow(to / from, Between01(i, points));
  }
  return all;
}

TransportPoint PointOf(const PoissonNernstPlanck& solution)
{
  return { solution.GetVoltage(), solution.GetFactor(), CurrentsOf(solution),
    solution.GetReport() };
}

void SolveAt(TransportPoint& point, PoissonNernstPlanck& solution, const ProgressCallback& progress)
{
  solution.SetBaths(point.Voltage, point.Factor);
  solution.Solve(progress);
  point = PointOf(solution);
}

}
