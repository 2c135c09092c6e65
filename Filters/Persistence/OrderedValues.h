/**
 * @file OrderedValues.h
 * @brief Values of any type as integers in the order of the filtration, and keys of cells.
 */
#ifndef isthmus_OrderedValues_h
#define isthmus_OrderedValues_h

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace isthmus
{

/**
 * The values of a volume as signed integers whose order is that in which the nodes enter.
 *
 * `Stored` is float, double or the unsigned integer of the same size as the values. -0.0 counts as
 * 0.0.
 */
template <typename Stored>
class OrderedValues
{
public:
  using Order = std::conditional_t<(sizeof(Stored) > 4), std::int64_t, std::int32_t>;

  OrderedValues(const Stored* values, bool isSigned, bool descending)
    : Values(values)
    , Signed(isSigned)
    , Flip(descending ? Order{ -1 } : Order{ 0 })
  {
  }

  Order operator[](std::int64_t node) const { return this->Convert(this->Values[node]); }

  /// The ordered integers of `count` values starting at `first`.
  void Convert(std::int64_t first, std::int64_t count, Order* orders) const
  {
    const Stored* values = this->Values + first;
    for (std::int64_t i = 0; i < count; ++i)
    {
      orders[i] = this->Convert(values[i]);
    }
  }

private:
  Order Convert(Stored value) const
  {
    if constexpr (std::is_floating_point_v<Stored>)
    {
      const Stored zeroed = value + Stored(0); // -0.0 + 0.0 is 0.0
      Order bits;
      std::memcpy(&bits, &zeroed, sizeof(bits));
      constexpr Order magnitude = std::is_same_v<Stored, float>
        ? static_cast<Order>(0x7fffffff)
        : static_cast<Order>(0x7fffffffffffffff);
      return (bits ^ ((bits >> (8 * sizeof(Order) - 1)) & magnitude)) ^ this->Flip;
    }
    else if constexpr (sizeof(Stored) < sizeof(Order))
    {
      // Converted to a wider type with its sign, if it has one.
      const Order plain = static_cast<Order>(value);
      const Order top =
        this->Signed ? static_cast<Order>(Order{ 1 } << (8 * sizeof(Stored) - 1)) : 0;
      return ((plain ^ top) - top) ^ this->Flip;
    }
    else
    {
      using Bits = std::make_unsigned_t<Order>;
      const Bits top = this->Signed ? Bits{ 0 } : Bits{ 1 } << (8 * sizeof(Order) - 1);
      return static_cast<Order>(static_cast<Bits>(value) ^ top) ^ this->Flip;
    }
  }

  const Stored* Values;
  bool Signed;
  Order Flip;
};

/// A key of 64 bits that orders the cells of a dimension by entry: 32 bits for the value, 28 for
/// the node, and 4 for the position in its star.
class NarrowKey
{
public:
  using Link = std::uint32_t; ///< holds a node and more
  static constexpr std::int64_t MostNodes = std::int64_t{ 1 } << 28;

  NarrowKey() = default;
  NarrowKey(std::int32_t order, std::int64_t node, int place)
    : Bits(static_cast<std::uint64_t>(static_cast<std::uint32_t>(order) ^ 0x80000000U) << 32 |
        static_cast<std::uint64_t>(node) << 4 | static_cast<std::uint64_t>(place))
  {
  }
  std::int64_t Node() const { return static_cast<std::int64_t>(this->Bits >> 4 & 0xfffffffU); }
  int Place() const { return static_cast<int>(this->Bits & 15U); }
  bool SameValue(NarrowKey other) const { return (this->Bits ^ other.Bits) >> 32 == 0; }
  std::uint64_t Hash() const { return this->Bits & 0xffffffffU; }
  bool operator<(NarrowKey other) const { return this->Bits < other.Bits; }
  bool operator==(NarrowKey other) const { return this->Bits == other.Bits; }

private:
  std::uint64_t Bits = 0;
};

/// The same for values of 64 bits and grids of any size, in 128 bits.
class WideKey
{
public:
  using Link = std::uint64_t;

  WideKey() = default;
  WideKey(std::int64_t order, std::int64_t node, int place)
    : Order(order)
    , Where(static_cast<std::uint64_t>(node) << 4 | static_cast<std::uint64_t>(place))
  {
  }
  std::int64_t Node() const { return static_cast<std::int64_t>(this->Where >> 4); }
  int Place() const { return static_cast<int>(this->Where & 15U); }
  bool SameValue(const WideKey& other) const { return this->Order == other.Order; }
  std::uint64_t Hash() const { return this->Where; }
  bool operator<(const WideKey& other) const
  {
    return this->Order != other.Order ? this->Order < other.Order : this->Where < other.Where;
  }
  bool operator==(const WideKey& other) const
  {
    return this->Order == other.Order && this->Where == other.Where;
  }

private:
  std::int64_t Order = 0;
  std::uint64_t Where = 0;
};

}

#endif
