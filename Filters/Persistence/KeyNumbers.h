/**
 * @file KeyNumbers.h
 * @brief From the key of a critical cell to its number in the sorted list.
 */
#ifndef isthmus_KeyNumbers_h
#define isthmus_KeyNumbers_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Numbers of keys in a sorted list, found in constant time. 8 to 16 bytes a key.
template <typename Key>
class KeyNumbers
{
public:
  explicit KeyNumbers(const std::vector<Key>& keys)
    : Keys(keys)
  {
    std::size_t slots = 16;
    while (slots < 2 * keys.size())
    {
      slots *= 2;
    }
    this->Slots.assign(slots, 0);
    for (std::size_t i = 0; i < keys.size(); ++i)
    {
      std::size_t slot = this->SlotOf(keys[i]);
      while (this->Slots[slot] != 0)
      {
        slot = (slot + 1) & (this->Slots.size() - 1);
      }
      this->Slots[slot] = static_cast<std::uint32_t>(i + 1);
    }
  }

  /// The number of a key that is in the list.
  std::size_t operator()(const Key& key) const
  {
    std::size_t slot = this->SlotOf(key);
    while (!(this->Keys[this->Slots[slot] - 1] == key))
    {
      slot = (slot + 1) & (this->Slots.size() - 1);
    }
    return this->Slots[slot] - 1;
  }

private:
  std::size_t SlotOf(const Key& key) const
  {
    return static_cast<std::size_t>(key.Hash() * 0x9e3779b97f4a7c15U >> 20) &
      (this->Slots.size() - 1);
  }

  const std::vector<Key>& Keys;
  std::vector<std::uint32_t> Slots;
};

}

#endif
