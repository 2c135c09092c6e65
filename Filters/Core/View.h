/**
 * @file View.h
 * @brief Non-owning view of consecutive elements of an array.
 */
#ifndef isthmus_View_h
#define isthmus_View_h

#include <cstddef>
#include <vector>

namespace isthmus
{

/// A read-only view that owns nothing and can be used in a range-based for.
template <typename T>
class View
{
public:
  View() = default;
  View(const T* first, std::size_t count)
    : First(first)
    , Count(count)
  {
  }
  /// @pre `elements` outlives the view and keeps its size.
  View(const std::vector<T>& elements)
    : View(elements.data(), elements.size())
  {
  }
  const T* begin() const { return this->First; }
  const T* end() const { return this->First + this->Count; }
  const T& operator[](std::size_t i) const { return this->First[i]; }
  const T& front() const { return *this->First; }
  std::size_t size() const { return this->Count; }
  bool empty() const { return this->Count == 0; }

private:
  const T* First = nullptr;
  std::size_t Count = 0;
};

}

#endif
