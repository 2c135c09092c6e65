/**
 * @file MoleculeFields.h
 * @brief Fields of the lines of molecule files: what is wrong with one is an error that names the
 * line, or is counted.
 */
#ifndef isthmus_MoleculeFields_h
#define isthmus_MoleculeFields_h

#include "Files/TextLines.h"
#include "Molecules/MoleculeParsers.h"
#include "Molecules/ReadingReport.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace isthmus
{

inline bool BeginsWith(std::string_view line, std::string_view with)
{
  return line.substr(0, with.size()) == with;
}

inline double FiniteNumber(std::string_view word, const TextLines& lines, const char* what)
{
  double value = 0.0;
  if (!IsNumber(word, value) || !std::isfinite(value))
  {
    lines.Fail(std::string(what) + " is expected where '" + std::string(word.substr(0, 30)) +
      "' is. The file may be truncated, or its name may not match its content.");
  }
  return value;
}

inline std::int64_t ReadCount(std::string_view word, const TextLines& lines, const char* what)
{
  std::int64_t value = 0;
  if (!IsNumber(word, value) || value < 0)
  {
    lines.Fail(std::string(what) + " is expected where '" + std::string(word.substr(0, 30)) +
      "' is. The file may be truncated, or its name may not match its content.");
  }
  return value;
}

inline std::string_view NextLine(TextLines& lines)
{
  std::string_view line;
  if (!lines.Next(line))
  {
    lines.Fail("the file ends within a molecule. Fetch or write it again.");
  }
  return line;
}

/// The whole number that `word` is, 0 and counted where it is none and not empty.
inline int IntegerOrZero(
  std::string_view word, const char* what, const TextLines& lines, ReadingReport& report)
{
  int value = 0;
  if (!word.empty() && !IsNumber(word, value))
  {
    report.Count(what, lines.Line());
  }
  return value;
}

/// The number that `word` is, unknown and counted where it is none and not empty.
inline double NumberOrUnknown(
  std::string_view word, const char* what, const TextLines& lines, ReadingReport& report)
{
  double value = 0.0;
  if (IsNumber(word, value) && std::isfinite(value))
  {
    return value;
  }
  if (!word.empty())
  {
    report.Count(what, lines.Line());
  }
  return Atom::Unknown;
}

inline constexpr const char* OddResidueNumbers =
  "Residue numbers that are not integers, taken as 0";
inline constexpr const char* OddCharges = "Charges that are not numbers, dropped";

/// An invalid bond does not discard its atoms. `a` and `b` are indices of atoms, -1 for missing
/// ones.
inline void AddBond(Macromolecule& molecule, std::optional<std::int64_t> a,
  std::optional<std::int64_t> b, const TextLines& lines, ReadingReport& report)
{
  const auto atoms = static_cast<std::int64_t>(molecule.Atoms.size());
  if (!a || !b)
  {
    report.Count("Unreadable bonds, dropped", lines.Line());
  }
  else if (*a < 0 || *b < 0 || *a >= atoms || *b >= atoms || *a == *b)
  {
    report.Count("Bonds with missing atoms, dropped", lines.Line());
  }
  else
  {
    molecule.Bonds.push_back({ std::min(*a, *b), std::max(*a, *b), true });
  }
}

/// The number of an atom in `word`, from 1.
inline std::optional<std::int64_t> AtomNumber(std::string_view word)
{
  std::int64_t number = 0;
  return IsNumber(word, number) ? std::optional<std::int64_t>(number) : std::nullopt;
}

/// The place of the atom with a number, -1 where there is none.
template <typename Places>
std::optional<std::int64_t> FindAtomIndex(std::string_view word, const Places& places)
{
  const std::optional<std::int64_t> number = AtomNumber(word);
  if (!number)
  {
    return {};
  }
  const auto found = places.find(*number);
  return found == places.end() ? std::int64_t{ -1 } : found->second;
}

}

#endif
