#include "Surfaces/SurfaceDefects.h"

#include <algorithm>

namespace isthmus
{

bool SurfaceDefects::None() const
{
  return this->InvalidPoints.empty() && this->InvalidTriangles.empty() &&
    this->DegenerateTriangles.empty() && this->DuplicateTriangles.empty() &&
    this->BoundaryTriangles.empty() && this->NonManifoldTriangles.empty() &&
    this->FlippedTriangles.empty() && this->NonManifoldPoints.empty();
}

std::string FirstIds(const std::vector<std::int64_t>& ids)
{
  constexpr std::size_t shown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, ids.size()); ++i)
  {
    text += (i ? ", " : "") + std::to_string(ids[i]);
  }
  return ids.size() > shown ? text + " and " + std::to_string(ids.size() - shown) + " more" : text;
}

std::string SurfaceDefects::Sentence() const
{
  std::string text;
  const auto add = [&text](const std::vector<std::int64_t>& ids, const char* what)
  {
    if (!ids.empty())
    {
      text += (text.empty() ? "" : "; ") + std::string(what) + " (" + FirstIds(ids) + ")";
    }
  };
  add(this->InvalidPoints, "points that are not finite");
  add(this->InvalidTriangles, "triangles with a repeated or missing point");
  add(this->DegenerateTriangles, "triangles without area");
  add(this->DuplicateTriangles, "duplicate triangles");
  add(this->BoundaryTriangles, "triangles at a hole");
  add(this->NonManifoldTriangles, "triangles at an edge of more than two");
  add(this->FlippedTriangles, "neighbouring triangles of opposite orientation");
  add(this->NonManifoldPoints, "points where sheets touch");
  return text.empty() ? text : "The surface has " + text + ".";
}

}
