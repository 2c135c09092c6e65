/**
 * @file InterfaceOperator.h
 * @brief The Poisson-Boltzmann equation on a box: 7-point rows, fitted rows at the surface, ions.
 *
 * Rows are multiplied by h^2 (h is the shortest spacing). The border is Dirichlet: the operator is
 * 0 there, and border values of the argument enter the rows beside it.
 */
#ifndef isthmus_InterfaceOperator_h
#define isthmus_InterfaceOperator_h

#include "Electrostatics/InterfaceMatrixRows.h"

#include <memory>

namespace isthmus
{

class InterfaceOperator
{
public:
  /// Box and sides are referred to, not copied.
  InterfaceOperator(const SolverBox& box, const std::vector<unsigned char>& inside,
    double soluteDielectric, double solventDielectric);

  void SetRows(InterfaceMatrixRows rows) { this->Rows = std::move(rows); }
  const InterfaceMatrixRows& GetRows() const { return this->Rows; }

  /// The ions' derivative h^2 d(charge)/du at each node; null for none. It is kept, not copied.
  void SetDiagonal(std::shared_ptr<const std::vector<float>> diagonal)
  {
    this->Diagonal = std::move(diagonal);
  }

  /// out = A z for a correction z, 0 on the border.
  void Apply(const std::vector<float>& z, std::vector<double>& out) const;

  /// out = b - A u with the values at the surface in b.
  void Residual(const std::vector<double>& u, std::vector<double>& out) const;

  /// One Gauss-Seidel pass over the fitted rows of A z = r, and a second one over those of closed
  /// cavities, with the term that these share.
  void SmoothIrregular(const std::vector<double>& r, std::vector<float>& z) const;

  /// The factor of the term of the ions in the equation of an irregular row.
  double RowScale(std::size_t row) const { return this->Rows.Scale[row]; }

private:
  /// Applies all rows; those of irregular nodes as if there were no surface.
  template <typename T>
  void ApplyRegularRows(const std::vector<T>& z, std::vector<double>& out, double sign) const;
  template <typename T>
  void ApplyIrregularRows(
    const std::vector<T>& z, std::vector<double>& out, double sign, bool withRight) const;
  /// Adds the term that the rows of a cavity share.
  template <typename T>
  void AddCavities(
    const std::vector<T>& z, std::vector<double>& out, double sign, bool withRight) const;

  /// Solves a row for its own value, with `common` and its diagonal added; returns the change.
  float SmoothRow(std::size_t row, double common, double commonDiagonal,
    const std::vector<double>& r, std::vector<float>& z) const;
  void SmoothCavity(
    const CavityFlux& cavity, const std::vector<double>& r, std::vector<float>& z) const;

  const SolverBox& Box;
  const std::vector<unsigned char>& Inside;
  double Solute, Solvent;
  Point3 Weights;
  InterfaceMatrixRows Rows;
  std::shared_ptr<const std::vector<float>> Diagonal;
};

}

#endif
