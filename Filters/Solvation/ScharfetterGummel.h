/**
 * @file ScharfetterGummel.h
 * @brief The flux of ions along an edge of a grid that is exact where the field is constant.
 *
 * J = -D (grad c + z c grad phi) with phi (kT/e) linear and J constant along an edge of length h
 * from p to q (D. L. Scharfetter, H. K. Gummel, IEEE Trans. Electron Devices 16 (1969) 64):
 *
 *   J = (D / h) g (v_p - v_q),   v = c exp(z phi),
 *   g = exp(-z (phi_p + phi_q) / 2) (x / 2) / sinh(x / 2),   x = z (phi_q - phi_p).
 *
 * In v (Slotboom's variable, mol/l) the equation div J = 0 is that of a network of resistors, whose
 * matrix is symmetric and an M-matrix: v lies between the baths' values, so c is never negative.
 */
#ifndef isthmus_ScharfetterGummel_h
#define isthmus_ScharfetterGummel_h

#include <cmath>

namespace isthmus
{

/// g from exp(-z phi / 2) at both ends.
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

}

#endif
