#include "Imaging/DiffusionOperator.h"

#include <cmath>

namespace isthmus
{

template <typename T>
DiffusionLags::DiffusionLags(const DiffusionOperator<T>& diffusion)
  : W(diffusion.Order())
  , C(0)
{
  if (diffusion.Coefficient != DiffusionCoefficient::Constant && !diffusion.StoredCoefficient)
  {
    this->C = diffusion.Coefficient == DiffusionCoefficient::Gram ? this->W + 1 : 1;
  }
  this->Out = std::max(this->W, this->C) + 1;
}

template <typename T>
int DiffusionOperator<T>::Reach() const
{
  return DiffusionLags(*this).Out;
}

template <typename T>
double DiffusionOperator<T>::SpectralBound() const
{
  double laplacian = 0.0;
  for (const double h : this->Spacing)
  {
    laplacian += 4.0 / (h * h);
  }
  double bound = 0.0;
  for (auto weight = this->Weights.rbegin(); weight != this->Weights.rend(); ++weight)
  {
    bound = bound * laplacian + std::abs(static_cast<double>(*weight));
  }
  // Horner's scheme runs from the highest order down, so bound is sum |weight_p| laplacian^p.
  return std::abs(static_cast<double>(this->Leading)) * bound * laplacian +
    static_cast<double>(this->Fidelity);
}

template struct DiffusionOperator<float>;
template struct DiffusionOperator<double>;
template DiffusionLags::DiffusionLags(const DiffusionOperator<float>&);
template DiffusionLags::DiffusionLags(const DiffusionOperator<double>&);

}
