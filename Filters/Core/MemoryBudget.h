/**
 * @file MemoryBudget.h
 * @brief How much memory a computation may take, decided before it allocates.
 */
#ifndef isthmus_MemoryBudget_h
#define isthmus_MemoryBudget_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <cstdint>
#include <string>

namespace isthmus
{

/// Bytes that the machine, the control group and the limits of this process leave. Infinite where
/// none of them can be determined (systems other than Linux).
VTKISTHMUSFILTERSCORE_EXPORT double AvailableMemory();

/// "1.5 GiB", "320 MiB".
VTKISTHMUSFILTERSCORE_EXPORT std::string MemoryText(double bytes);

/**
 * The memory that a computation may take: the user's limit, or what is available where there is
 * none. Each algorithm predicts its own bytes; whether they fit, and the message where they do not,
 * are decided here:
 *
 *     MemoryBudget(filter->GetMemoryLimit()).Require(130.0 * nodes, "A grid of 9 x 9 x 9 nodes",
 *       "choose a larger Spacing");
 */
class VTKISTHMUSFILTERSCORE_EXPORT MemoryBudget
{
public:
  /// @param limit in MiB, as the property MemoryLimit of filters; 0 or less: what is available now
  explicit MemoryBudget(double limit = 0.0);

  /// A limit in bytes that the caller has decided, e.g. by WholeBytes(); 0: no limit at all.
  static MemoryBudget OfBytes(std::uint64_t bytes);

  /// What may be taken. Infinite where there is no limit and the memory is unknown.
  double Bytes() const { return this->Allowed; }

  /// The same, but `bytes` at most; that counts as a limit of the user's.
  MemoryBudget AtMost(double bytes) const;

  /// The same for interfaces in which 0 means that there is no limit (ulimit); never 0 else.
  std::uint64_t WholeBytes() const;

  /// Whether a prediction fits. NaN, infinity and what no machine has (1e18) never do.
  bool Allows(double bytes) const;

  /// "WHAT needs about 3 GiB of memory, but only 1 GiB are available: REMEDY.", or, under a limit,
  /// "... but MemoryLimit is 1 GiB: REMEDY, or raise MemoryLimit."
  std::string Message(double bytes, const std::string& what, const std::string& remedy) const;

  /// @param what    subject of the message, in the singular, with the sizes that count
  /// @param remedy  what to do, by the name of a property: "choose a larger Spacing"
  /// @throws std::runtime_error with Message() unless Allows(bytes).
  void Require(double bytes, const std::string& what, const std::string& remedy) const;

private:
  double Allowed;
  bool HasLimit;
};

}

#endif
