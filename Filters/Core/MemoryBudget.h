/**
 * @file MemoryBudget.h
 * @brief Checks how much memory a computation may use, before it allocates.
 */
#ifndef isthmus_MemoryBudget_h
#define isthmus_MemoryBudget_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <array>
#include <cstdint>
#include <string>

namespace isthmus
{

/// Number of bytes that the machine, the control group and the limits of this process allow.
/// Infinite if none of them can be determined (systems other than Linux).
VTKISTHMUSFILTERSCORE_EXPORT double AvailableMemory();

/// "1.5 GiB", "320 MiB".
VTKISTHMUSFILTERSCORE_EXPORT std::string MemoryText(double bytes);

/**
 * The memory that a computation may use: the user's limit, or the available memory if there is
 * none. Each algorithm predicts its own bytes; this class checks whether they fit and composes the
 * error message:
 *
 *     MemoryBudget(this->MemoryLimit).Require(
 *       450.0 * triangles, "A surface of 9 million triangles", "choose a larger EdgeLength");
 */
class VTKISTHMUSFILTERSCORE_EXPORT MemoryBudget
{
public:
  /// @param limit in MiB, the property MemoryLimit of filters; 0: the available memory
  /// @throws std::invalid_argument unless it is 0 or more.
  explicit MemoryBudget(double limit = 0.0);

  /// A limit in MiB as well, but 0 means three quarters of the machine's memory, no matter how much
  /// of it is in use. This is for algorithms whose result depends on the budget and must not depend
  /// on other programs that run.
  static MemoryBudget ForMachine(double limit);

  /// A limit in bytes chosen by the caller, e.g. from WholeBytes(); 0: no limit.
  static MemoryBudget ForBytes(std::uint64_t bytes);

  /// The memory that may be used. Infinite if there is no limit and the memory is unknown.
  double Bytes() const { return this->Allowed; }

  /// The same, but at most `bytes`, which is treated as a limit set by the user.
  MemoryBudget AtMost(double bytes) const;

  /// The same for interfaces in which 0 means no limit (ulimit): 0 if there is no limit, otherwise
  /// never 0.
  std::uint64_t WholeBytes() const;

  /// Whether a prediction fits. NaN, infinity and more than any machine has (1e18) never fit.
  bool Allows(double bytes) const;

  /// "WHAT needs about 3 GiB of memory, but only 1 GiB are available: REMEDY.", or, under a limit,
  /// "... but MemoryLimit is 1 GiB: REMEDY, or raise MemoryLimit."
  std::string Message(double bytes, const std::string& what, const std::string& remedy) const;

  /// @param what    subject of the message, in the singular, with the relevant sizes
  /// @param remedy  what to do, naming a property: "choose a larger Spacing"
  /// @throws std::runtime_error with Message() unless Allows(bytes).
  void Require(double bytes, const std::string& what, const std::string& remedy) const;

  /// Require() for "A grid of 9 x 9 x 9 nodes" with this number of bytes for each node.
  void RequireGrid(const std::array<std::int64_t, 3>& dimensions, double bytesPerNode,
    const std::string& remedy) const;

private:
  double Allowed;
  bool HasLimit;
};

}

#endif
