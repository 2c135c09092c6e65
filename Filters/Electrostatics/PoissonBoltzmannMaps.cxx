// What the equation was solved with, as maps on the image's nodes.

#include "Electrostatics/PoissonBoltzmannOutput.h"

#include "Core/ParallelFor.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <cmath>

namespace isthmus
{
namespace
{

vtkSmartPointer<vtkFloatArray> Map(const char* name, vtkImageData* image, int components)
{
  auto map = vtkSmartPointer<vtkFloatArray>::New();
  map->SetName(name);
  map->SetNumberOfComponents(components);
  map->SetNumberOfTuples(image->GetNumberOfPoints());
  map->FillValue(0.0F);
  return map;
}

/// Calls use(node of the image, node of the box) for all nodes of the image, in parallel.
template <class Use>
void ForNodesOf(vtkImageData* image, const SolverBox& box, const Use& use)
{
  int n[3];
  image->GetDimensions(n);
  ParallelFor(0, n[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        for (std::int64_t j = 0; j < n[1]; ++j)
        {
          for (std::int64_t i = 0; i < n[0]; ++i)
          {
            use(static_cast<vtkIdType>(i + n[0] * (j + n[1] * k)),
              static_cast<std::size_t>(i - box.First[0] +
                box.Dimensions[0] * (j - box.First[1] + box.Dimensions[1] * (k - box.First[2]))));
          }
        }
      }
    });
}

vtkSmartPointer<vtkFloatArray> AccessMap(const PotentialOnBox& solution, vtkImageData* image)
{
  auto map = Map("IonAccessibility", image, 1);
  const IonAtmosphere& ions = solution.GetIons();
  if (ions.Empty())
  {
    return map;
  }
  std::vector<float> share;
  for (std::size_t l = 0; l < ions.NumberOfLayers(); ++l)
  {
    share.push_back(static_cast<float>(ions.Derivative(l, 0.0) / ions.Linear()));
  }
  ForNodesOf(image, solution.GetBox(),
    [&](vtkIdType to, std::size_t from)
    {
      float sum = 0.0F;
      for (std::size_t l = 0; l < share.size(); ++l)
      {
        sum += share[l] * solution.GetAccess()[l][from];
      }
      map->SetValue(to, sum);
    });
  return map;
}

vtkSmartPointer<vtkFloatArray> ChargeMap(
  const std::vector<ChargedAtom>& onGrid, const SolverBox& box, vtkImageData* image)
{
  auto map = Map("ChargeDensity", image, 1);
  int n[3];
  image->GetDimensions(n);
  const double volume = box.Spacing[0] * box.Spacing[1] * box.Spacing[2];
  for (const ChargedAtom& atom : onGrid)
  {
    std::int64_t low[3];
    double t[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double place = atom.Position[a] / box.Spacing[a];
      low[a] = static_cast<std::int64_t>(std::floor(place));
      t[a] = place - std::floor(place);
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      double weight = atom.Charge / volume;
      std::int64_t at[3];
      bool within = true;
      for (int a = 0; a < 3; ++a)
      {
        const bool upper = (corner >> a & 1) != 0;
        weight *= upper ? t[a] : 1.0 - t[a];
        at[a] = low[a] + (upper ? 1 : 0);
        within = within && at[a] >= 0 && at[a] < n[a];
      }
      if (within)
      {
        const vtkIdType node = at[0] + n[0] * (at[1] + n[1] * at[2]);
        map->SetValue(node, map->GetValue(node) + static_cast<float>(weight));
      }
    }
  }
  return map;
}

}

void FillMaps(
  const PotentialOnBox& solution, const std::vector<ChargedAtom>& onGrid, vtkImageData* image)
{
  const SolverBox& box = solution.GetBox();
  auto dielectric = Map("Dielectric", image, 3);
  const char* const edges[] = { "x", "y", "z" };
  for (int a = 0; a < 3; ++a)
  {
    dielectric->SetComponentName(a, edges[a]);
  }
  const EdgePermittivity permittivity = solution.Permittivities();
  ForNodesOf(image, box,
    [&](vtkIdType to, std::size_t from)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        dielectric->SetTypedComponent(
          to, static_cast<int>(a), permittivity.Table[permittivity.Code[a][from]]);
      }
    });
  image->GetPointData()->AddArray(dielectric);
  image->GetPointData()->AddArray(AccessMap(solution, image));
  image->GetPointData()->AddArray(ChargeMap(onGrid, box, image));
}

}
