#include "ChokingLoops/MeshFunctionError.h"

#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/NumberText.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

double LongestEdge(const CellFiltration& mesh, const std::array<SimplexId, 4>& corners)
{
  double longest = 0.0;
  for (std::size_t a = 0; a < 4; ++a)
  {
    for (std::size_t b = 0; b < a; ++b)
    {
      longest =
        std::max(longest, Length(mesh.Points[At(corners[a])] - mesh.Points[At(corners[b])]));
    }
  }
  return longest;
}

}

std::vector<CellError> DistanceErrors(const CellFiltration& mesh, const std::vector<double>& values,
  const std::vector<double>& atPoints)
{
  const double jung = std::sqrt(3.0 / 8.0);
  std::vector<CellError> errors;
  errors.reserve(mesh.Tetrahedra.size());
  for (const auto& corners : mesh.Tetrahedra)
  {
    double least = HUGE_VAL;
    double atCorners = 0.0;
    for (const SimplexId p : corners)
    {
      least = std::min(least, values[At(p)]);
      atCorners = std::max(atCorners, atPoints.empty() ? 0.0 : atPoints[At(p)]);
    }
    const double error = jung * LongestEdge(mesh, corners) + atCorners;
    errors.push_back({ error, std::max(0.0, least - error) });
  }
  return errors;
}

std::vector<CellError> RangeErrors(const CellFiltration& mesh, const std::vector<double>& values)
{
  std::vector<CellError> errors;
  errors.reserve(mesh.Tetrahedra.size());
  for (const auto& corners : mesh.Tetrahedra)
  {
    const auto [least, most] = std::minmax({ values[At(corners[0])], values[At(corners[1])],
      values[At(corners[2])], values[At(corners[3])] });
    errors.push_back({ most - least, least });
  }
  return errors;
}

std::string MeshRemark(const FeatureDiagram& diagram)
{
  std::size_t generators = 0, others = 0;
  double widest = 0.0; // largest persistence of a narrowing within the error
  double error = 0.0;
  for (const ShapeFeature& f : diagram.Features)
  {
    const bool isOther = f.Dimension == 2 && f.Kind == FeatureKind::Noise && f.PairBirth > 0.0;
    if (f.Trusted || !(IsGenerator(f) || (isOther && f.Persistence() > f.FunctionError)))
    {
      continue;
    }
    generators += isOther ? 0 : 1;
    others += isOther ? 1 : 0;
    widest = std::max(widest, isOther ? f.Persistence() : 0.0);
    error = std::max(error, f.FunctionError);
  }
  if (generators + others == 0)
  {
    return {};
  }
  std::string remark = "The tetrahedra are too coarse for ";
  if (generators > 0)
  {
    remark += std::to_string(generators) +
      (generators == 1 ? " handle or tunnel" : " handles and tunnels") +
      ", whose radius is smaller than its uncertainty (not trusted)";
  }
  if (others > 0)
  {
    remark += std::string(generators > 0 ? ", and for " : "") + std::to_string(others) +
      (others == 1 ? " other narrowing" : " other narrowings") + " of persistence up to " +
      FormatNumber(widest, 3) + ", not reported";
  }
  return remark + ". The error of the function reaches " + FormatNumber(error, 3) +
    ". Give a finer mesh on the second input, or use the Delaunay filtration.";
}

}
