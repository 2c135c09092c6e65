/**
 * @file Cached.h
 * @brief The last result of a computation, valid as long as its input is unchanged.
 */
#ifndef isthmus_Cached_h
#define isthmus_Cached_h

#include <vtkObject.h>

#include <optional>
#include <utility>

namespace isthmus
{

/// The state of a VTK object as part of a key, `{ nullptr, 0 }` for none. Modification times are
/// unique, so another object at the same address has another state.
using ObjectState = std::pair<const void*, vtkMTimeType>;

inline ObjectState GetState(vtkObject* object)
{
  return { object, object ? object->GetMTime() : 0 };
}

/**
 * Holds one value with its key. A key contains everything that the value depends on, e.g.
 * `std::tuple<ObjectState, double>`; keys that are not equal replace each other.
 *
 *     const Analysis& analysis = this->Internals->Analysis.Get(
 *       { isthmus::GetState(surface), this->Spacing }, [&] { return Analyse(surface); });
 */
template <typename Key, typename Value>
class Cached
{
public:
  /// The value for `key`: the cached one, or what `make` returns, which is then cached. The old
  /// value is freed before `make` is called; if that throws, nothing is cached.
  template <typename Make>
  Value& Get(const Key& key, Make&& make)
  {
    if (!this->Find(key))
    {
      this->Clear();
      this->Entry.emplace(key, std::forward<Make>(make)());
    }
    return this->Entry->second;
  }

  /// The value for `key`; null if it is not cached.
  Value* Find(const Key& key)
  {
    return this->Entry && this->Entry->first == key ? &this->Entry->second : nullptr;
  }

  /// The cached value of any key; null if there is none.
  Value* Last() { return this->Entry ? &this->Entry->second : nullptr; }

  void Clear() { this->Entry.reset(); }

private:
  std::optional<std::pair<Key, Value>> Entry;
};

}

#endif
