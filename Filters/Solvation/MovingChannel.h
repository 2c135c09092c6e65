/**
 * @file MovingChannel.h
 * @brief A channel whose wall moves under the ions' forces: Laplace-Beltrami and
 * Poisson-Nernst-Planck equations, coupled.
 *
 * The coupled Laplace-Beltrami and Poisson-Nernst-Planck equations (thesis 4.25 to 4.28; G. W. Wei,
 * Q. Zheng, Z. Chen, K. Xia, SIAM Rev. 54 (2012) 699) in sharp form. Everything except water, i.e.
 * atoms and membrane together, has one surface; it flows (SurfaceFlow.h) by
 *
 *   phi_t = |grad phi| div(grad phi / |grad phi|) - (V_2 / gamma) |grad phi|,
 *   -V_2 = p - rho_0 U + pull of field and ions (WallForce.h),
 *
 * for a period of steps with the pull fixed (CoupledFlow.h); then potential and ions are solved
 * for with the wall where it is (PoissonNernstPlanck.h, from the last solution), the pull is
 * computed again, and so on until the currents, and the water in the membrane's hole, change by
 * less than UpdateTolerance twice in a row. If a change undoes the previous one (e.g. a crease that
 * the field opens and tension closes alternately), the fraction of new forces that is used is
 * halved from then on.
 *
 * The surface starts on its obstacle, the surface of the molecule without motion, so the first
 * update is ion transport without motion. From then on, the tension may close creases and pores,
 * but cannot open regions that the obstacle occupies. The membrane is an obstacle, too; it is flat
 * with a round hole.
 */
#ifndef isthmus_MovingChannel_h
#define isthmus_MovingChannel_h

#include "MolecularSurfaces/Dispersion.h"
#include "Solvation/ChannelPassage.h"
#include "Solvation/CoupledFlow.h"
#include "Solvation/SolvationParameters.h"
#include "Solvation/TransportCurrents.h"
#include "Solvation/WallForce.h"

#include <memory>

namespace isthmus
{

/// After each solution.
struct ChannelUpdate
{
  double Time = 0.0;            ///< of the flow, square angstrom
  double AreaChange = 0.0;      ///< since the start, square angstrom
  double LumenVolume = 0.0;     ///< water within the membrane's thickness, cubic angstrom
  double EnergyChange = 0.0;    ///< of tension, pressure and dispersion since the start, kcal/mol
  double OnObstacle = 0.0;      ///< the part of the wall that its obstacle holds, 0 to 1
  double Bottleneck = 0.0;      ///< radius, angstrom
  std::vector<double> Currents; ///< pA, by species

  double Current() const; ///< of all of them
};

/// Cost: a solution of PoissonNernstPlanck.h for each update, and UpdatePeriod steps of O(band
/// nodes) between them. Memory: twice that of the solution (the next one starts from the last), and
/// 40 bytes for each node for the flow. The result is bitwise the same on any number of threads.
class MovingChannel
{
public:
  static constexpr double BytesPerNode = 500.0;

  /// The domain with a margin for the rim of the membrane: the grid on which distances are needed.
  static TransportDomain Padded(const TransportDomain& domain);
  /// Values on the nodes of Padded(domain) at those of `domain`.
  static std::vector<float> Unpadded(
    const std::vector<float>& values, const TransportDomain& domain);

  /// `obstacle` are distances to the molecule (TransportGrid.h) on the nodes of Padded(domain), or
  /// nothing where there is a membrane only; `atoms` are those that attract the water.
  /// @throws std::invalid_argument for parameters out of range.
  MovingChannel(const TransportDomain& domain, const std::vector<float>& obstacle,
    std::vector<ChargedAtom> charges, const std::vector<DispersionAtom>& atoms,
    const IonTransportParameters& transport, const MovingChannelParameters& parameters);
  ~MovingChannel();
  MovingChannel(const MovingChannel&) = delete;
  void operator=(const MovingChannel&) = delete;

  /// Runs until convergence or MaximumUpdates; at this limit, the state that changed least is kept.
  /// @throws std::runtime_error, with the place, if the channel is closed at the start or closes
  /// during the motion; the exceptions of PoissonNernstPlanck::Solve; Cancelled.
  void Run(const ProgressCallback& progress = {});

  /// Whether currents and lumen volume have converged.
  bool HasConverged() const;
  /// The largest relative change of the last update.
  double LastChange() const;
  /// The update to which the solution belongs.
  std::size_t GetShown() const { return this->ShownUpdate; }
  const std::vector<ChannelUpdate>& GetUpdates() const { return this->Updates; }
  const ChannelPassage& GetPassage() const { return this->Passage; }
  /// The current pull at the wall; positions are those of Padded(domain).
  WallValues ForceAtWall() const;
  const PoissonNernstPlanck& GetSolution() const { return *this->Solution; }

private:
  void Start(const std::vector<float>& obstacle);
  void Solve(const ProgressCallback& progress);
  void Record();
  bool Oscillates() const;
  void Pull();
  double Change(std::size_t update) const;
  double SteadyEnergy() const;

  const TransportDomain Domain, Room;
  const std::vector<ChargedAtom> Charges;
  const IonTransportParameters Transport;
  const MovingChannelParameters Parameters;
  FlowField Field;
  std::vector<float> Steady; ///< the constant part of the pull, in spacings
  double ForceFraction;      ///< of each new force
  double Time = 0.0;
  double FirstArea = 0.0, FirstEnergy = 0.0;
  std::size_t ShownUpdate = 0;
  std::vector<float> Best; ///< distances of the update that changed least
  double LeastChange = 0.0;
  ChannelPassage Passage;
  std::unique_ptr<TransportGrid> Grid;
  std::unique_ptr<PoissonNernstPlanck> Solution;
  std::vector<ChannelUpdate> Updates;
};

}

#endif
