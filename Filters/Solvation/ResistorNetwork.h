/**
 * @file ResistorNetwork.h
 * @brief Values at the nodes of a grid whose edges conduct, some of them held: solved by conjugate
 * gradients.
 *
 * At each node that is not held
 *
 *   sum_q g_pq (u_p - u_q) + d_p u_p = s_p,   g >= 0, d >= 0.
 *
 * The matrix is a symmetric M-matrix. Conjugate gradients are preconditioned by its modified
 * incomplete Cholesky factor without fill (I. Gustafsson, BIT 18 (1978) 142), taken for 0.97
 * modified, as R. Bridson has it (Fluid Simulation for Computer Graphics, 2008, ch. 4). That makes
 * some nodes^(1/6) iterations for conductances that jump by many powers of ten, which geometric
 * multigrid does not stand: 30 to 60 on 2 x 10^5 nodes. Large grids have a factor for each of up to
 * eight slabs, which leaves out the edges between them.
 */
#ifndef isthmus_ResistorNetwork_h
#define isthmus_ResistorNetwork_h

#include "Core/Progress.h"
#include "vtkIsthmusFiltersSolvationModule.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace isthmus
{

/// Memory: 80 bytes a node. Time: about 20 ns a node and iteration on one thread; parallel from
/// 130,000 nodes on, bitwise the same on any number of threads.
class VTKISTHMUSFILTERSSOLVATION_EXPORT ResistorNetwork
{
public:
  /// `held`, one value a node, is referred to: not 0 where u is given.
  ResistorNetwork(
    const std::array<std::int64_t, 3>& dimensions, const std::vector<unsigned char>& held);

  /// Conductance of the edge from a node to the next along `axis`; that of a last node stays 0.
  double& Edge(std::size_t axis, std::int64_t node)
  {
    return this->Edges[axis][static_cast<std::size_t>(node + this->Margin)];
  }
  double& Diagonal(std::int64_t node)
  {
    return this->Diagonals[static_cast<std::size_t>(node + this->Margin)];
  }

  /// After the conductances were set, and before Solve().
  void Factor();

  /// The sum of |s - A u| over the nodes that are not held; `source` may be empty for 0.
  double Residual(const std::vector<double>& u, const std::vector<double>& source);

  /// What terms g u that cancel add up to: their rounding is the least that a residual can be.
  /// After Factor().
  double SumOfMagnitudes(const std::vector<double>& u) const;

  struct Control
  {
    double Limit = 0.0;     ///< of the sum of |s - A u|
    double Reduction = 0.0; ///< the same as a part of what it is at first
    int MaximumIterations = 2000;
  };
  struct Answer
  {
    int Iterations = 0;
    double Residual = 0.0; ///< the sum that is left
    bool Converged = false;
  };

  /// Improves u until the sum of its residuals is below either limit. Reports 0 every few
  /// iterations.
  /// @throws std::runtime_error where numbers leave the range of doubles, Cancelled.
  Answer Solve(std::vector<double>& u, const std::vector<double>& source, const Control& control,
    const ProgressCallback& progress = {});

private:
  struct Slab; ///< planes of nodes that one factor is for
  std::int64_t FirstPlane(std::int64_t slab) const;
  void ForEachSlab(const std::function<void(const Slab&)>& work) const;
  template <typename Work>
  double SumOverNodes(Work&& work) const;
  void FactorSlab(const Slab& slab);
  double SolveSlab(const Slab& slab);
  double Multiply();
  double Precondition();

  std::array<std::int64_t, 3> Dimensions;
  std::int64_t Nodes;
  std::int64_t Slabs;
  std::array<std::int64_t, 3> Steps;
  std::int64_t Margin; ///< zeros before and behind, so that no loop asks for borders
  const std::vector<unsigned char>& Held;
  std::array<std::vector<double>, 3> Edges;
  std::vector<double> Diagonals;
  std::vector<double> Sum;     ///< of a node's conductances and its diagonal; 0 where it is held
  std::vector<double> Inverse; ///< of the factor's pivots; 0 where it is held
  std::vector<double> R, Z, P, Q;
  std::vector<double> Zeros; ///< a row beyond a slab
};

}

#endif
