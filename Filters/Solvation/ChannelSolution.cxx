#include "Solvation/ChannelSolution.h"

#include "Core/MemoryBudget.h"
#include "Core/PolyDataTriangles.h"
#include "MolecularSurfaces/AtomsInside.h"
#include "MolecularSurfaces/FlowField.h"
#include "Solvation/IonTransportOutput.h"
#include "Solvation/TransportCurrents.h"
#include "Surfaces/GridDistance.h"
#include "Surfaces/GridImages.h"
#include "Surfaces/SurfaceCrossings.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// The distance from each node to closed triangles, angstrom, negative within, cut at 4.5 spacings.
/// Parallel. Sets `warning` if charges lie outside; atoms if there are no charges.
/// @throws std::invalid_argument where they are not closed or most of these lie outside, Cancelled.
std::vector<float> DistanceToClosed(const TransportDomain& domain, const ChannelProblem& problem,
  std::string& warning, const ProgressCallback& progress)
{
  vtkPolyData* const surface = problem.Surface;
  if (surface->GetNumberOfPoints() == 0)
  {
    throw std::invalid_argument(
      "The surface on input 1 is empty: connect the closed surface of the molecule, or remove the "
      "input to use a surface computed from the atoms.");
  }
  vtkNew<vtkImageData> image;
  SetImageGeometry(domain, image);
  const GridShape shape = GetGridShape(image);
  const auto inAxes = InGridAxes(surface, image);
  const PolyDataTriangles triangles(inAxes);
  const std::vector<unsigned char> inside =
    NodesInside(triangles.View(), shape, MakeWorldTransform(image));
  const std::vector<double> distance = DistanceToSurface(
    triangles.View(), shape, static_cast<double>(FlowGrid::Band) * domain.Spacing, progress);
  std::vector<float> to(distance.size());
  for (std::size_t node = 0; node < to.size(); ++node)
  {
    to[node] = static_cast<float>(inside[node] != 0 ? -distance[node] : distance[node]);
  }
  std::vector<Point3> positions;
  for (const ChargedAtom& atom : problem.Charges)
  {
    if (atom.Charge != 0.0)
    {
      positions.push_back(atom.Position);
    }
  }
  const bool isCharged = !positions.empty();
  if (!isCharged) // a pore of carbon, for instance
  {
    for (const Ball& ball : problem.Balls)
    {
      positions.push_back(ball.Center);
    }
  }
  warning = CheckAtomsInside(image, to, positions, isCharged ? "charged atoms" : "atoms");
  return to;
}

}

ChannelSolution::ChannelSolution(const ChannelProblem& problem, const ProgressCallback& progress)
  : Domain(DomainAround(problem.Balls, problem.Transport))
{
  const IonTransportParameters& p = problem.Transport;
  const TransportDomain room = problem.Moves ? MovingChannel::Padded(this->Domain) : this->Domain;
  if (problem.Moves)
  {
    MemoryBudget().RequireGrid(
      room.Dimensions, MovingChannel::BytesPerNode, "choose a larger Spacing or a smaller Padding");
  }
  const auto first = Between(progress, 0.0, 0.15);
  const std::vector<float> distances = problem.Surface
    ? DistanceToClosed(room, problem, this->SurfaceWarning, first)
    : DistanceToAtoms(room, problem.Balls, p.ProbeRadius, first);
  if (problem.Moves)
  {
    // Where the surface starts: tension then rounds the rim, and water leaves it.
    this->RimIsOpen = isthmus::IsRimOpen(
      MakeTransportGrid(this->Domain, MovingChannel::Unpadded(distances, this->Domain), {}, p),
      problem.Balls, p);
    this->Moving = std::make_unique<MovingChannel>(
      this->Domain, distances, problem.Charges, problem.Attracting, p, problem.Motion);
    this->Moving->Run(Between(progress, 0.15, 1.0));
    return;
  }
  this->Grid = std::make_unique<TransportGrid>(MakeTransportGrid(this->Domain, distances,
    problem.Charges, p, PermittivityMean::OverFace, Between(progress, 0.15, 0.3)));
  this->Passage = FindPassage(*this->Grid);
  RequireOpen(this->Passage);
  CloseIsolatedPockets(*this->Grid);
  this->RimIsOpen = isthmus::IsRimOpen(*this->Grid, problem.Balls, p);
  this->Fixed = std::make_unique<PoissonNernstPlanck>(*this->Grid, p);
  this->Fixed->Solve(Between(progress, 0.3, 1.0));
}

double EstimateCurrentError(
  const ChannelProblem& problem, const ChannelSolution& solution, const ProgressCallback& progress)
{
  // The wall of a round pore is resolved to a fraction of spacing^2 / radius.
  constexpr double wall = 0.8;
  const double current = ComputeCurrents(solution.Get()).Mean();
  const double h = problem.Transport.Spacing;
  // Radii of passages end at the width of the band of distances.
  const double radius = solution.GetPassage().Radius;
  const bool isWide = radius > 0.95 * static_cast<double>(FlowGrid::Band) * h;
  const double relative = h / std::max(radius, isWide ? problem.Transport.LumenRadius : radius);
  ChannelProblem coarse = problem;
  coarse.Transport.Spacing *= 1.5;
  double change = current; // if that closes the channel
  try
  {
    change = ComputeCurrents(ChannelSolution(coarse, progress).Get()).Mean() - current;
  }
  catch (const Cancelled&)
  {
    throw;
  }
  catch (const std::exception&)
  {
  }
  return std::hypot(change, wall * relative * relative * current);
}

}
