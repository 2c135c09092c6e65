/**
 * @file ChannelSolution.h
 * @brief Potential and ions of a channel with a fixed or moving surface.
 */
#ifndef isthmus_ChannelSolution_h
#define isthmus_ChannelSolution_h

#include "Atoms/Ball.h"
#include "Solvation/MovingChannel.h"

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace isthmus
{

struct ChannelProblem
{
  std::vector<Ball> Balls;
  std::vector<ChargedAtom> Charges;
  vtkPolyData* Surface = nullptr; ///< closed; nullptr: the solvent-excluded surface of the balls
  IonTransportParameters Transport;
  bool Moves = false;
  std::vector<DispersionAtom> Attracting; ///< for a moving surface
  MovingChannelParameters Motion;         ///< for a moving surface
};

/// The constructor solves the problem.
class ChannelSolution
{
public:
  /// @throws what its parts throw; Cancelled.
  explicit ChannelSolution(const ChannelProblem& problem, const ProgressCallback& progress = {});

  const PoissonNernstPlanck& Get() const
  {
    return this->Moving ? this->Moving->GetSolution() : *this->Fixed;
  }
  const ChannelPassage& GetPassage() const
  {
    return this->Moving ? this->Moving->GetPassage() : this->Passage;
  }
  /// Warning about the given surface; empty if there is none (AtomsInside.h).
  const std::string& GetSurfaceWarning() const { return this->SurfaceWarning; }
  /// IsRimOpen(), of the first surface if it moves.
  bool IsRimOpen() const { return this->RimIsOpen; }
  /// Null if the surface is fixed.
  const MovingChannel* GetMoving() const { return this->Moving.get(); }

private:
  const TransportDomain Domain;
  std::string SurfaceWarning;
  ChannelPassage Passage;
  bool RimIsOpen = false;
  std::unique_ptr<TransportGrid> Grid;
  std::unique_ptr<PoissonNernstPlanck> Fixed;
  std::unique_ptr<MovingChannel> Moving;
};

/**
 * An estimate of the error of the whole current of a solution of `problem`, pA: the change of the
 * current with 1.5 times the spacing, and 0.8 (spacing / radius of the pore)^2 of the current, the
 * error of the wall's position on the grid. It covers what follows from the resolution, not the
 * equations.
 *
 * Cost: a third of a solution. @throws Cancelled.
 */
double EstimateCurrentError(const ChannelProblem& problem, const ChannelSolution& solution,
  const ProgressCallback& progress = {});

}

#endif
