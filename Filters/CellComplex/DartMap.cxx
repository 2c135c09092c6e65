#include "CellComplex/DartMap.h"

#include <algorithm>

namespace isthmus
{

template <typename Id>
auto DartMap<Id>::FurtherUmbrellas(Vertex vertex) const -> View<std::pair<Vertex, Dart>>
{
  if (this->Umbrellas.empty())
  {
    return {};
  }
  const auto range = std::equal_range(this->Umbrellas.begin(), this->Umbrellas.end(),
    std::pair<Vertex, Dart>(vertex, Dart()),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  return { this->Umbrellas.data() + (range.first - this->Umbrellas.begin()),
    static_cast<std::size_t>(range.second - range.first) };
}

template class DartMap<std::uint32_t>;
template class DartMap<std::uint64_t>;

}
