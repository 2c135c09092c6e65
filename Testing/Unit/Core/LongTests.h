/**
 * @file LongTests.h
 * @brief Decides which of the long cases of a test are run.
 *
 * All of them with ISTHMUS_LONG_TESTS=1. Otherwise one of `hands` shares, selected by the hash of
 * the test's name and the number ISTHMUS_TURN. Testing/run.sh sets it to the number of merges, so
 * that each merge runs another share. Without ISTHMUS_TURN none runs. The same in Python:
 * Testing/Python/long_tests.py.
 */
#ifndef isthmus_LongTests_h
#define isthmus_LongTests_h

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace isthmus::testing
{

class LongCases
{
public:
  /// `name` decides in which run a case is done, and is printed by ReportCases(). After `hands`
  /// consecutive merges all cases have run.
  LongCases(std::string name, std::uint64_t hands)
    : Name(std::move(name))
    , Hands(hands)
  {
    std::uint32_t hash = 2166136261U; // FNV-1a, as in Testing/select_tests.py
    for (const char c : this->Name)
    {
      hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
    }
    const char* all = std::getenv("ISTHMUS_LONG_TESTS");
    const char* turn = std::getenv("ISTHMUS_TURN");
    this->All = all && std::string(all) == "1";
    this->Some = turn && *turn;
    this->Turn = this->Some ? (std::strtoull(turn, nullptr, 10) + hash) % hands : 0;
  }

  /// Whether case `index`, counted from 0, is run.
  bool Has(std::uint64_t index) const
  {
    return this->All || (this->Some && index % this->Hands == this->Turn);
  }

  /// The first of `count` further random seeds, other ones in each run; 0 where none are to be run.
  std::uint64_t FirstSeed(std::uint64_t count) const
  {
    return this->Some ? 1000 + this->Turn * count : 0;
  }

  /// Prints the number of cases done and the total.
  void ReportCases(std::size_t done, std::size_t of) const
  {
    std::printf("%s: %zu of %zu cases done (%s)\n", this->Name.c_str(), done, of,
      this->All      ? "ISTHMUS_LONG_TESTS=1: all"
        : this->Some ? ("long ones: turn " + std::to_string(this->Turn + 1) + " of " +
                         std::to_string(this->Hands))
                         .c_str()
                     : "no long ones: ISTHMUS_TURN is not set");
  }

private:
  std::string Name;
  std::uint64_t Hands;
  bool All = false, Some = false;
  std::uint64_t Turn = 0;
};

}

#endif
