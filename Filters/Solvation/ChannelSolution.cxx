#include "Solvation/ChannelSolution.h"

#include "Solvation/IonTransportInput.h"

namespace isthmus
{

ChannelSolution::ChannelSolution(const ChannelProblem& problem, const ProgressCallback& progress)
  : Domain(DomainAround(problem.Balls, problem.Transport))
{
  const IonTransportParameters& p = problem.Transport;
  const TransportDomain room = problem.Moves ? MovingChannel::Roomy(this->Domain) : this->Domain;
  if (problem.Moves)
  {
    RequireMemory(room, MovingChannel::BytesPerNode);
  }
  const auto first = Between(progress, 0.0, 0.15);
  const std::vector<float> distances = problem.Surface
    ? DistanceToClosed(room, problem.Surface, first)
    : DistanceToAtoms(room, problem.Balls, p.ProbeRadius, first);
  if (problem.Moves)
  {
    this->Moving = std::make_unique<MovingChannel>(
      this->Domain, distances, problem.Charges, problem.Attracting, p, problem.Motion);
    this->Moving->Run(Between(progress, 0.15, 1.0));
    return;
  }
  this->Grid = std::make_unique<TransportGrid>(
    MakeTransportGrid(this->Domain, distances, problem.Charges, p, Between(progress, 0.15, 0.3)));
  this->Passage = FindPassage(*this->Grid);
  DemandOpen(this->Passage);
  ClosePockets(*this->Grid);
  this->Still = std::make_unique<PoissonNernstPlanck>(*this->Grid, p);
  this->Still->Solve(Between(progress, 0.3, 1.0));
}

}
