/**
 * @file PoissonNernstPlanck.h
 * @brief Steady drift and diffusion of ions through a channel in a self-consistent field.
 *
 * The steady Poisson-Nernst-Planck equations (thesis 4.19 to 4.28, with a fixed surface):
 *
 *   -div(eps grad phi) = 4 pi C (charges + sum_k z_k N c_k),
 *   div J_k = 0,   J_k = -D_k (grad c_k + z_k c_k grad phi)   in the water,
 *
 * phi in kT/e, c_k in mol/l, C the Coulomb length, N ions in a cubic angstrom at 1 mol/l. In the
 * baths phi and c_k are given; there is no flux of ions through walls, and no field through the
 * side of the domain.
 *
 * Finite volumes (TransportGrid.h) with fluxes after Scharfetter and Gummel (IEEE
 * Trans. Electron Devices 16 (1969) 64), exact where phi is linear along an edge of length h from
 * node p to node q:
 *
 *   J = (D / h) g (v_p - v_q),   v = c exp(z phi),
 *   g = exp(-z (phi_p + phi_q) / 2) (x / 2) / sinh(x / 2),   x = z (phi_q - phi_p).
 *
 * In v (Slotboom's variable, mol/l) the equation div J = 0 is that of a network of resistors, whose
 * matrix is symmetric and an M-matrix: v lies between the values of the baths, so c is never
 * negative.
 *
 * Gummel's iteration (IEEE Trans. Electron Devices 11 (1964) 455) alternates between Nernst-Planck
 * with phi given, linear in Slotboom's v_k = c_k exp(z_k phi), and Poisson with v_k given, by
 * Newton's method: the charge of the ions decreases as phi increases, so that equation has exactly
 * one solution. Both are networks of resistors (ResistorNetwork.h). The iteration ends when phi
 * changes by less than Tolerance everywhere in the water.
 */
#ifndef isthmus_PoissonNernstPlanck_h
#define isthmus_PoissonNernstPlanck_h

#include "Core/Handles.h"
#include "Core/Progress.h"
#include "Solvation/ResistorNetwork.h"
#include "Solvation/TransportGrid.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace isthmus
{

/// The g of the Scharfetter-Gummel flux from exp(-z phi / 2) at both ends of an edge.
inline double SlotboomConductance(double rootP, double rootQ)
{
  const double ratio = rootP / rootQ; // exp(x / 2)
  const double product = rootP * rootQ;
  if (std::abs(ratio - 1.0) < 1e-4)
  {
    const double half =
      ratio - 1.0; // x / 2 = half - half^2 / 2 + ..., and the series is even in it
    return product * (1.0 - half * half / 6.0);
  }
  return product * 2.0 * std::log(ratio) / (ratio - 1.0 / ratio);
}

/// A species by its index in IonTransportParameters::Species.
using SpeciesId = Handle<struct SpeciesKind, std::size_t>;

/// Memory for each node: 160 bytes for two networks, 40 for phi and work arrays, 8 for each
/// species. Parallel, with results that are bitwise the same on any number of threads.
class PoissonNernstPlanck
{
public:
  /// The object refers to `grid`.
  /// @throws std::invalid_argument for parameters out of range.
  PoissonNernstPlanck(const TransportGrid& grid, const IonTransportParameters& parameters);

  /// Sets another voltage (mV). The next Solve() starts from the current state.
  void SetVoltage(double voltage);

  /// Starts from the result of another object, on a grid of the same size whose wall has another
  /// position.
  void StartFrom(const PoissonNernstPlanck& other);

  /// Iterates until convergence or MaximumIterations; at this limit, the state that changed least
  /// is kept. If a linear system could not be solved, so that more than 1e-4 of a current is lost
  /// along the channel (Imbalance), the iteration has not converged.
  /// @throws Cancelled, and std::runtime_error if numbers overflow.
  const IonTransportReport& Solve(const ProgressCallback& progress = {});

  const TransportGrid& GetGrid() const { return this->Grid; }
  const IonTransportParameters& GetParameters() const { return this->Parameters; }
  const IonTransportReport& GetReport() const { return this->Report; }
  double GetVoltage() const { return this->Voltage; } ///< mV
  const std::vector<double>& GetPotential() const { return this->Phi; }
  /// Slotboom's v of a species, mol/l.
  const std::vector<double>& GetSlotboom(SpeciesId species) const { return this->V[species]; }
  /// mol/l; 0 where there is no water.
  double Concentration(SpeciesId species, std::int64_t node) const;
  bool IsWater(std::int64_t node) const { return this->Open[static_cast<std::size_t>(node)] != 0; }
  /// Flux along the edge from a node to the next one, positive in this direction, in angstrom mol/l
  /// times 1e-9 m^2/s.
  double EdgeFlux(SpeciesId species, std::size_t axis, std::int64_t node) const;

private:
  double Mobility(SpeciesId species, std::int64_t node) const;
  /// Conductance of an open edge, from exp(-z phi / 2) at both ends, with the mobilities of both in
  /// series.
  double EdgeConductance(SpeciesId species, std::size_t axis, std::int64_t node, double rootHere,
    double rootThere) const;
  double BathValue(SpeciesId species, unsigned char bath) const;
  void FillNernstPlanck(SpeciesId species);
  double SolveSpecies(SpeciesId k, double accuracy, const ProgressCallback& progress);
  void SolveNernstPlanck(double accuracy, const ProgressCallback& progress);
  void ForNodes(const std::function<void(std::int64_t)>& work) const;
  void FillCharge();
  double SolvePoisson(double accuracy, const ProgressCallback& progress);
  double NewtonStep(const ProgressCallback& progress);
  double Throughput(SpeciesId species) const;
  double NegligibleCurrent(SpeciesId species) const;

  const TransportGrid& Grid;
  const IonTransportParameters Parameters;
  const double ChargeScale;        ///< from mol/l in a node's cube to the source of phi
  double Voltage = 0.0;            ///< mV
  std::vector<unsigned char> Open; ///< nodes with faces that are water
  std::vector<double> Phi;
  HandleVector<SpeciesId, std::vector<double>> V;
  std::vector<double> Source, Work;
  ResistorNetwork Field, Ions;
  IonTransportReport Report;
};

}

#endif
