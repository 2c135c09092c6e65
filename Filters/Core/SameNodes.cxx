#include "Core/SameNodes.h"

#include <vtkImageData.h>

#include <cmath>
#include <stdexcept>

namespace isthmus
{

void RequireSameNodes(vtkImageData* one, vtkImageData* other)
{
  const int* n = one->GetDimensions();
  const int* m = other->GetDimensions();
  bool same = n[0] == m[0] && n[1] == m[1] && n[2] == m[2];
  for (int corner = 0; same && corner < 8; ++corner)
  {
    double p[3], q[3];
    const int* e = one->GetExtent();
    const int* f = other->GetExtent();
    one->TransformIndexToPhysicalPoint(
      e[corner & 1], e[2 + (corner >> 1 & 1)], e[4 + (corner >> 2 & 1)], p);
    other->TransformIndexToPhysicalPoint(
      f[corner & 1], f[2 + (corner >> 1 & 1)], f[4 + (corner >> 2 & 1)], q);
    for (int a = 0; a < 3; ++a)
    {
      same = same && std::abs(p[a] - q[a]) <= 1e-4 * one->GetSpacing()[a];
    }
  }
  if (!same)
  {
    throw std::invalid_argument("The half maps do not have the same nodes: take two halves of one "
                                "reconstruction, with the same box, spacing and origin.");
  }
}

}
