#include "Core/InvertedCells.h"

#include <cmath>

namespace isthmus
{

void InvertedCells::Add(vtkIdType cell, double signedVolume)
{
  this->Sum += signedVolume;
  if (signedVolume == 0.0)
  {
    return; // flat: neither order
  }
  Side& side = signedVolume > 0.0 ? this->Positive : this->Negative;
  ++side.Count;
  if (side.First.size() < Named)
  {
    side.First.push_back(cell);
  }
}

const InvertedCells::Side& InvertedCells::Minority() const
{
  return this->Sum >= 0.0 ? this->Negative : this->Positive;
}

std::int64_t InvertedCells::Count() const
{
  return this->Minority().Count;
}

double InvertedCells::Volume() const
{
  return std::abs(this->Sum);
}

std::string InvertedCells::Message() const
{
  const Side& inverted = this->Minority();
  if (inverted.Count == 0)
  {
    return {};
  }
  const bool one = inverted.Count == 1;
  std::string ids;
  for (const vtkIdType id : inverted.First)
  {
    ids += (ids.empty() ? "" : ", ") + std::to_string(id);
  }
  ids += static_cast<std::size_t>(inverted.Count) > inverted.First.size() ? ", ..." : "";
  return std::to_string(inverted.Count) + " of " +
    std::to_string(this->Positive.Count + this->Negative.Count) + " cells " +
    (one ? "is inverted (cell " : "are inverted (cells ") + ids +
    "): their corners are ordered opposite to those of the others, as where a mesh overlaps "
    "itself, "
    "and their volume counts as negative. Untangle or remesh it before computing on it.";
}

}
