/**
 * @file ScatteredMemory.h
 * @brief Blocks of many sizes, half of them freed: what is allocated next has other addresses.
 */
#ifndef isthmus_ScatteredMemory_h
#define isthmus_ScatteredMemory_h

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace isthmus::testing
{

/// For tests of results that must not depend on addresses: construct an object with another seed
/// before each run, and keep it until the run ends.
class ScatteredMemory
{
public:
  explicit ScatteredMemory(std::uint64_t seed)
  {
    std::mt19937_64 random(seed);
    for (int i = 0; i < 4000; ++i)
    {
      this->Blocks.emplace_back(8 + random() % (i % 2 == 0 ? 400 : 20000), static_cast<char>(i));
    }
    std::shuffle(this->Blocks.begin(), this->Blocks.end(), random);
    this->Blocks.resize(this->Blocks.size() / 2);
  }

private:
  std::vector<std::vector<char>> Blocks;
};

}

#endif
