/**
 * @file LongTests.h
 * @brief Which of the long cases of a test run now.
 *
 * All of them with ISTHMUS_LONG_TESTS=1. Else a share: the cases are dealt out to a few hands, and
 * ISTHMUS_TURN, any number, says whose turn it is. Testing/run.sh sets it to the commit's date, so
 * that each landing runs another share and a few landings run everything; one commit always runs
 * the same. Without ISTHMUS_TURN none runs. Python's twin is Testing/Python/long_tests.py.
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
  /// `name` is for the line that Tell() prints; `hands`: about so many landings run all cases.
  LongCases(std::string name, std::uint64_t hands)
    : Name(std::move(name))
    , Hands(hands)
  {
    const char* all = std::getenv("ISTHMUS_LONG_TESTS");
    const char* turn = std::getenv("ISTHMUS_TURN");
    this->All = all && std::string(all) == "1";
    this->Some = turn && *turn;
    this->Turn = this->Some ? std::strtoull(turn, nullptr, 10) % hands : 0;
  }

  /// Whether case `index`, counted from 0, runs now.
  bool Has(std::uint64_t index) const
  {
    return this->All || (this->Some && index % this->Hands == this->Turn);
  }

  /// The first of `count` further random seeds, others at each turn; 0 where none are to be run.
  std::uint64_t FirstSeed(std::uint64_t count) const
  {
    return this->Some ? 1000 + this->Turn * count : 0;
  }

  /// Prints how many of how many cases were done.
  void Tell(std::size_t done, std::size_t of) const
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
