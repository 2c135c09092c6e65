/**
 * @file ResistorNetwork.h
 * @brief Solves for the values at the nodes of a grid whose edges are conductors, some of them with
 * fixed values, by conjugate gradients.
 *
 * At each node whose value is not given
 *
 *   sum_q g_pq (u_p - u_q) + d_p u_p = s_p,   g >= 0, d >= 0.
 *
 * The matrix is a symmetric M-matrix. Conjugate gradients are preconditioned by its modified
 * incomplete Cholesky factor without fill-in (I. Gustafsson, BIT 18 (1978) 142), with a
 * modification parameter of 0.97, as proposed by R. Bridson (Fluid Simulation for Computer
 * Graphics, 2008, ch. 4). The number of iterations is about nodes^(1/6), or 30 to 60 for 2 x 10^5
 * nodes, even for conductances that jump by many powers of ten, which geometric multigrid cannot
 * handle. Large grids have a separate factor for each of up to eight slabs, which neglects the
 * edges between the slabs.
 */
#ifndef isthmus_ResistorNetwork_h
#define isthmus_ResistorNetwork_h

#include "Core/Progress.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace isthmus
{

/// Memory: 80 bytes per node. Time: O(nodes) per iteration; parallel for more than 130,000 nodes,
/// with results that are bitwise the same on any number of threads.
class ResistorNetwork
{
public:
  /// `held`, one value per node, is kept as a reference: not 0 where u is given.
  ResistorNetwork(
    const std::array<std::int64_t, 3>& dimensions, const std::vector<unsigned char>& held);

  /// Conductance of the edge from a node to the next along `axis`; that of the last node must stay
  /// 0.
  double& Edge(std::size_t axis, std::int64_t node)
  {
    return this->Edges[axis][static_cast<std::size_t>(node + this->Margin)];
  }
  double& Diagonal(std::int64_t node)
  {
    return this->Diagonals[static_cast<std::size_t>(node + this->Margin)];
  }

  /// To be called after the conductances were set, and before Solve().
  void Factor();

  /// The sum of |s - A u| over the nodes without a given value; `source` may be empty for 0.
  double Residual(const std::vector<double>& u, const std::vector<double>& source);

  /// Sum of the magnitudes of the terms g u, which cancel in the residual; their rounding limits
  /// how small the residual can become. After Factor().
  double SumOfMagnitudes(const std::vector<double>& u) const;

  struct Control
  {
    double Limit = 0.0;     ///< of the sum of |s - A u|
    double Reduction = 0.0; ///< the same as a fraction of the initial sum
    int MaximumIterations = 2000;
  };
  struct Answer
  {
    int Iterations = 0;
    double Residual = 0.0; ///< the remaining sum
    bool Converged = false;
  };

  /// Iterates u until the sum of its residuals is below either limit. Reports a progress of 0 every
  /// few iterations.
  /// @throws std::runtime_error if numbers exceed the range of doubles, Cancelled.
  Answer Solve(std::vector<double>& u, const std::vector<double>& source, const Control& control,
    const ProgressCallback& progress = {});

private:
  struct Slab; ///< planes of nodes per factor
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
  std::int64_t Margin; ///< zeros before and after, so that loops need no tests at borders
  const std::vector<unsigned char>& Held;
  std::array<std::vector<double>, 3> Edges;
  std::vector<double> Diagonals;
  std::vector<double>
    Sum; ///< of a node's conductances and its diagonal; 0 where the value is given
  std::vector<double> Inverse; ///< of the factor's pivots; 0 where the value is given
  std::vector<double> R, Z, P, Q;
  std::vector<double> Zeros; ///< a row beyond a slab
};

}

#endif
