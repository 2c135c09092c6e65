#include "AnalysisCost.h"

#include "AvailableMemory.h"

namespace isthmus
{

bool FitsMemory(std::size_t samples, double limit, std::string& sentence)
{
  const double bytes = AnalysisBytes(samples);
  const double most = limit > 0.0 ? limit : AvailableMemory();
  if (bytes <= most)
  {
    return true;
  }
  sentence = "Choking loops of " + std::to_string(samples) + " samples take some " +
    MemoryText(bytes) + ", and " +
    (limit > 0.0 ? "MemoryLimit is " + MemoryText(most)
                 : "only " + MemoryText(most) + " are available") +
    ": raise SampleSpacing" + (limit > 0.0 ? " or MemoryLimit." : ", or simplify the surface.");
  return false;
}

}
