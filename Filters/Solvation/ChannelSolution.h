/**
 * @file ChannelSolution.h
 * @brief Potential and ions of a channel whose surface is at rest or moves, from VTK's atoms on.
 */
#ifndef isthmus_ChannelSolution_h
#define isthmus_ChannelSolution_h

#include "Atoms/Ball.h"
#include "Solvation/MovingChannel.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace isthmus
{

struct ChannelProblem
{
  std::vector<Ball> Balls;
  std::vector<ChargedAtom> Charges;
  vtkPolyData* Surface = nullptr; ///< closed; without it the balls' own is made
  IonTransportParameters Transport;
  bool Moves = false;
  std::vector<DispersionAtom> Attracting; ///< where it moves
  MovingChannelParameters Motion;         ///< likewise
};

/// Solved when it is made.
class ChannelSolution
{
public:
  /// @throws what its parts do, with sentences; Cancelled.
  explicit ChannelSolution(const ChannelProblem& problem, const ProgressCallback& progress = {});

  PoissonNernstPlanck& Get() { return this->Moving ? this->Moving->GetSolution() : *this->Still; }
  const ChannelPassage& GetPassage() const
  {
    return this->Moving ? this->Moving->GetPassage() : this->Passage;
  }
  /// Nothing where the surface is at rest.
  const MovingChannel* GetMoving() const { return this->Moving.get(); }

private:
  const TransportDomain Domain;
  ChannelPassage Passage;
  std::unique_ptr<TransportGrid> Grid;
  std::unique_ptr<PoissonNernstPlanck> Still;
  std::unique_ptr<MovingChannel> Moving;
};

}

#endif
