/**
 * @file IdMap.h
 * @brief What is known of some of very many ids: points of a surface, tetrahedra of a complex.
 */
#ifndef isthmus_IdMap_h
#define isthmus_IdMap_h

#include <CGAL/Unique_hash_map.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace isthmus
{

/**
 * CGAL's table of numbers, which asks for no memory of its own for each of them. What was never set
 * is what the map was made with. Constant time; 36 bytes a value of four bytes, at most 72.
 */
template <typename Id, typename Value>
class IdMap
{
public:
  explicit IdMap(Value unset)
    : Table(unset)
  {
  }
  // A copy of CGAL's table has another default.
  IdMap(const IdMap&) = delete;
  IdMap& operator=(const IdMap&) = delete;

  const Value& operator[](Id id) const { return this->Table[Number(id)]; }
  Value& operator[](Id id) { return this->Table[Number(id)]; }

private:
  struct Same
  {
    std::size_t operator()(std::size_t number) const { return number; }
  };

  /// None, the only id below 0, comes last.
  static std::size_t Number(Id id)
  {
    if constexpr (std::is_integral_v<Id>)
    {
      return static_cast<std::uint32_t>(id);
    }
    else
    {
      return static_cast<std::uint32_t>(id.Value);
    }
  }

  CGAL::Unique_hash_map<std::size_t, Value, Same> Table;
};

}

#endif
