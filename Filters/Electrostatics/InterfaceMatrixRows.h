/**
 * @file InterfaceMatrixRows.h
 * @brief The equations of the nodes next to the surface, as rows of a sparse matrix.
 *
 * Row of a node p on a side with permittivity eps, times h^2 (h the shortest spacing):
 * eps sum_axes (h / h_a)^2 (2 u_p - v_before - v_after) = 0, where v is the value of a neighbour on
 * the same side, or, for a neighbour on the other side, the value continued across the surface by
 * InterfaceJumpConditions. The rows of a closed cavity share a term (ClosedCavities.h) that is not
 * in their entries. The term of the ions is not in the row; it is added by InterfaceOperator. Rows
 * are scaled so that their diagonal is that of the preconditioner.
 */
#ifndef isthmus_InterfaceMatrixRows_h
#define isthmus_InterfaceMatrixRows_h

#include "Electrostatics/ClosedCavities.h"

namespace isthmus
{

/// Compressed rows; columns are distances in nodes from the row's own node.
struct InterfaceMatrixRows
{
  std::vector<std::int64_t> Node;  ///< in increasing order
  std::vector<std::int64_t> Start; ///< of each row, and the end
  std::vector<std::int32_t> Column;
  std::vector<double> Value;
  std::vector<double> RightSide;
  std::vector<double> Scale;    ///< that the row was multiplied with
  std::vector<double> Diagonal; ///< after scaling
  std::vector<CavityFlux> Cavities;
  std::int64_t LinearFits = 0;
  std::int64_t GhostFits = 0;
};

/// O(crossings); parallel; bitwise the same on any number of threads.
InterfaceMatrixRows AssembleIrregularRows(
  const InterfaceProblem& problem, const ProgressCallback& progress = {});

/// The permittivity of an edge that the surface crosses; `fraction` is the part of it in the
/// solute.
inline double SeriesPermittivity(double solute, double solvent, double fraction)
{
  return 1.0 / (fraction / solute + (1.0 - fraction) / solvent);
}

}

#endif
