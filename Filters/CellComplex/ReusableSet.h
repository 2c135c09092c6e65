/**
 * @file ReusableSet.h
 * @brief A small set of ids for one walk after another.
 */
#ifndef isthmus_ReusableSet_h
#define isthmus_ReusableSet_h

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace isthmus
{

/**
 * A set of ids that is emptied in constant time and keeps its memory: 8 kB (16 for 64-bit ids), or
 * four slots an id once there were more than 512. Whether an id is new is an even chance in a walk,
 * so that Insert has no branch on it; with few of the slots taken, two ids seldom want the same
 * one.
 */
template <typename Id>
class ReusableSet
{
  struct Slot
  {
    Id Key = 0;
    Id Stamp = 0;
  };

public:
  ReusableSet() { this->Slots.resize(std::size_t(1) << (64 - this->Shift)); }

  void Clear()
  {
    this->Size = 0;
    if (++this->Stamp == 0)
    {
      std::fill(this->Slots.begin(), this->Slots.end(), Slot{});
      this->Stamp = 1;
    }
  }

  /// The set as a loop wants it, in registers; valid until the set is asked for more room.
  class Marks
  {
  public:
    /// False if `id` was there already.
    bool Insert(Id id) const
    {
      Slot* slot = this->Slots +
        static_cast<std::size_t>((std::uint64_t(id) * 0x9E3779B97F4A7C15u) >> this->Shift);
      if ((slot->Stamp == this->Stamp) & (slot->Key != id))
      {
        slot = this->Probe(slot, id);
      }
      const bool fresh = slot->Stamp != this->Stamp;
      *slot = { id, this->Stamp };
      return fresh;
    }

  private:
    friend class ReusableSet;
    Marks(Slot* slots, unsigned shift, Id stamp)
      : Slots(slots)
      , Shift(shift)
      , Stamp(stamp)
    {
    }

    /// The slot of `id`, or a free one for it, where its first choice, `taken`, is another's.
    [[gnu::noinline, gnu::cold]] Slot* Probe(Slot* taken, Id id) const
    {
      Slot* const end = this->Slots + (std::size_t(1) << (64 - this->Shift));
      while (taken->Stamp == this->Stamp && taken->Key != id)
      {
        taken = taken + 1 == end ? this->Slots : taken + 1;
      }
      return taken;
    }

    Slot* Slots;
    unsigned Shift;
    Id Stamp;
  };

  /// Makes room for `ids` altogether, so many that Room() tells.
  Marks WithRoomFor(std::size_t ids)
  {
    while (this->Room() < ids)
    {
      this->Grow();
    }
    this->Size = std::max(this->Size, ids);
    return { this->Slots.data(), this->Shift, this->Stamp };
  }
  std::size_t Room() const { return this->Slots.size() / 2; }

  /// False if `id` was there already.
  bool Insert(Id id)
  {
    const std::size_t before = this->Size;
    const bool fresh = this->WithRoomFor(before + 1).Insert(id);
    this->Size = before + (fresh ? 1 : 0);
    return fresh;
  }

private:
  [[gnu::noinline, gnu::cold]] void Grow()
  {
    std::vector<Slot> old(2 * this->Slots.size());
    old.swap(this->Slots);
    --this->Shift;
    const Marks marks{ this->Slots.data(), this->Shift, this->Stamp };
    for (const Slot& slot : old)
    {
      if (slot.Stamp == this->Stamp)
      {
        marks.Insert(slot.Key);
      }
    }
  }

  std::vector<Slot> Slots;
  unsigned Shift = 64 - 10;
  Id Stamp = 1;
  std::size_t Size = 0; // at least what is in it
};

}

#endif
