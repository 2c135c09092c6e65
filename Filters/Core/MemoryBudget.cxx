#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Core/SystemMemory.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr double Unknown = std::numeric_limits<double>::infinity();

/// More bytes than any machine has, within the range of std::size_t.
constexpr double Most = 1e18;

}

double AvailableMemory()
{
  return std::max(0.0, std::min(FreeMemory(), AddressSpaceLeft()));
}

std::string MemoryText(double bytes)
{
  const char* units[] = { "KiB", "MiB", "GiB", "TiB", "PiB", "EiB" };
  std::size_t unit = 0;
  double amount = bytes / 1024.0;
  while (amount >= 999.5 && unit + 1 < std::size(units))
  {
    amount /= 1024.0;
    ++unit;
  }
  return FormatNumber(amount, 3) + ' ' + units[unit];
}

MemoryBudget::MemoryBudget(double limit)
  : Allowed(limit > 0.0 ? limit * 1048576.0 : AvailableMemory())
  , HasLimit(limit > 0.0)
{
  RequireThat(
    limit >= 0.0, "MemoryLimit", limit, "it must be 0 (the memory of the machine) or more");
}

MemoryBudget MemoryBudget::ForMachine(double limit)
{
  MemoryBudget budget(limit);
  if (!budget.HasLimit)
  {
    budget.Allowed = 0.75 * TotalMemory();
  }
  return budget;
}

MemoryBudget MemoryBudget::ForBytes(std::uint64_t bytes)
{
  MemoryBudget budget(1.0);
  budget.Allowed = bytes > 0 ? static_cast<double>(bytes) : Unknown;
  return budget;
}

MemoryBudget MemoryBudget::AtMost(double bytes) const
{
  MemoryBudget budget = *this;
  if (bytes < budget.Allowed)
  {
    budget.Allowed = bytes;
    budget.HasLimit = true;
  }
  return budget;
}

std::uint64_t MemoryBudget::WholeBytes() const
{
  return this->Allowed < Most
    ? std::max<std::uint64_t>(1, static_cast<std::uint64_t>(this->Allowed))
    : 0;
}

bool MemoryBudget::Allows(double bytes) const
{
  return bytes <= this->Allowed && bytes < Most;
}

std::string MemoryBudget::Message(
  double bytes, const std::string& what, const std::string& remedy) const
{
  return what + " needs about " + MemoryText(bytes) + " of memory, but " +
    (this->HasLimit ? "MemoryLimit is " + MemoryText(this->Allowed)
                    : "only " + MemoryText(this->Allowed) + " are available") +
    ": " + remedy + (this->HasLimit ? ", or raise MemoryLimit." : ".");
}

void MemoryBudget::Require(double bytes, const std::string& what, const std::string& remedy) const
{
  if (!this->Allows(bytes))
  {
    throw std::runtime_error(this->Message(bytes, what, remedy));
  }
}

void MemoryBudget::RequireGrid(const std::array<std::int64_t, 3>& dimensions, double bytesPerNode,
  const std::string& remedy) const
{
  const auto& [nx, ny, nz] = dimensions;
  const double nodes = static_cast<double>(nx) * static_cast<double>(ny) * static_cast<double>(nz);
  this->Require(
    bytesPerNode * nodes, JoinText("A grid of ", nx, " x ", ny, " x ", nz, " nodes"), remedy);
}

}
