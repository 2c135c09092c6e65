/**
 * @file Handles.h
 * @brief Typed ids: the id of an edge cannot be passed as that of a triangle, nor a position in an
 * order as either of them.
 */
#ifndef isthmus_Handles_h
#define isthmus_Handles_h

#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace isthmus
{

/**
 * An id of one kind. It needs no more memory or time than its integer, and does not convert
 * implicitly to another kind or to a number.
 *
 * @tparam Kind a tag type that distinguishes kinds; need not be complete
 * @tparam Id the integer; only a signed one has a value for "none"
 */
template <typename Kind, typename Id>
struct Handle
{
  Id Value = 0;

  constexpr Handle() = default;
  explicit constexpr Handle(Id value)
    : Value(value)
  {
  }

  /// The id with this index in a vector. @pre `index` fits into Id.
  static constexpr Handle At(std::size_t index) { return Handle(static_cast<Id>(index)); }

  /// The value that represents no id: -1, below all others.
  static constexpr Handle None()
  {
    static_assert(std::is_signed_v<Id>, "only a signed id can represent none");
    return Handle(Id{ -1 });
  }
  constexpr bool Exists() const
  {
    static_assert(std::is_signed_v<Id>, "an unsigned id always exists");
    return this->Value >= 0;
  }

  /// Its index in a vector. @pre it is not None().
  constexpr std::size_t Index() const { return static_cast<std::size_t>(this->Value); }

  friend constexpr bool operator==(Handle a, Handle b) { return a.Value == b.Value; }
  friend constexpr bool operator!=(Handle a, Handle b) { return a.Value != b.Value; }
  friend constexpr bool operator<(Handle a, Handle b) { return a.Value < b.Value; }
  friend constexpr bool operator>(Handle a, Handle b) { return a.Value > b.Value; }
  friend constexpr bool operator<=(Handle a, Handle b) { return a.Value <= b.Value; }
  friend constexpr bool operator>=(Handle a, Handle b) { return a.Value >= b.Value; }
};

/// A range of consecutive ids, for a range-based `for`.
template <typename Key>
class HandleRange
{
public:
  class Iterator
  {
  public:
    explicit Iterator(std::size_t index)
      : Index(index)
    {
    }
    Key operator*() const { return Key::At(this->Index); }
    Iterator& operator++()
    {
      ++this->Index;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return this->Index != other.Index; }

  private:
    std::size_t Index;
  };

  /// The ids from 0 to count - 1.
  explicit HandleRange(std::size_t count)
    : End(count)
  {
  }
  /// The ids from begin to end - 1, as ParallelFor() assigns rounds. @pre neither is negative.
  template <typename Integer>
  HandleRange(Integer begin, Integer end)
    : Begin(static_cast<std::size_t>(begin))
    , End(static_cast<std::size_t>(end))
  {
  }

  Iterator begin() const { return Iterator(this->Begin); }
  Iterator end() const { return Iterator(this->End); }

private:
  std::size_t Begin = 0;
  std::size_t End;
};

/// Values of all ids of a kind: a vector that only such an id can index.
template <typename Key, typename Value>
class HandleVector : public std::vector<Value>
{
  using Base = std::vector<Value>;

public:
  using Base::Base;
  HandleVector() = default;
  explicit HandleVector(Base values)
    : Base(std::move(values))
  {
  }

  Value& operator[](Key id) { return Base::operator[](id.Index()); }
  const Value& operator[](Key id) const { return Base::operator[](id.Index()); }

  /// The ids that have values.
  HandleRange<Key> Keys() const { return HandleRange<Key>(this->size()); }
};

}

/// @cond
template <typename Kind, typename Id>
struct std::hash<isthmus::Handle<Kind, Id>>
{
  std::size_t operator()(isthmus::Handle<Kind, Id> id) const { return std::hash<Id>()(id.Value); }
};
/// @endcond

#endif
