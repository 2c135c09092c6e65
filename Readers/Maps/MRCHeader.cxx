#include "Maps/MRCHeader.h"

#include "Maps/MRCHeaderWords.h"

#include <limits>

namespace isthmus
{

std::uint64_t MRCHeader::DataBytes() const
{
  return MRCDataBytes(this->Counts, this->Voxel.Mode);
}

std::uint64_t MRCHeader::FileBytes() const
{
  const std::uint64_t head = mrcHeaderBytes + static_cast<std::uint64_t>(this->ExtendedHeaderBytes);
  const std::uint64_t data = this->DataBytes();
  return data > std::numeric_limits<std::uint64_t>::max() - head ? data : head + data;
}

}
