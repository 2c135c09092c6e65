#include "Persistence/PersistenceCache.h"

#include "Persistence/CubicalPersistence.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkSOADataArrayTemplate.h>

#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

template <typename T>
VolumeView TypedView(const void* values, const std::array<std::int64_t, 3>& dimensions)
{
  return VolumeView(static_cast<const T*>(values), dimensions);
}

/// Whether the values are in memory, in one buffer or in one for each component.
template <typename T>
bool IsStored(vtkDataArray* values)
{
  return values->HasStandardMemoryLayout() ||
    vtkArrayDownCast<vtkSOADataArrayTemplate<T>>(values) != nullptr;
}

}

VolumeView MakeVolumeView(vtkDataArray* scalars, vtkImageData* image)
{
  const int* n = image->GetDimensions();
  const std::array<std::int64_t, 3> dimensions{ n[0], n[1], n[2] };
  // GetVoidPointer copies arrays of one buffer for each component into another that they keep.
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(if (IsStored<VTK_TT>(scalars)) return TypedView<VTK_TT>(
      scalars->GetVoidPointer(0), dimensions));
    default:
      break;
  }
  throw std::invalid_argument("The scalars are stored as " + std::string(scalars->GetClassName()) +
    ", but a plain array of numbers is needed: copy them to one first (with the Calculator, for "
    "instance).");
}

const VolumeStatistics& PersistenceCache::Statistics(
  vtkDataArray* scalars, const VolumeView& volume)
{
  return this->OfVolume.Get({ GetState(scalars), volume.Dimensions },
    [&]
    {
      this->Diagram.Clear();
      return MeasureVolume(volume);
    });
}

const CubicalDiagram& PersistenceCache::Pairs(
  const VolumeView& volume, const CubicalParameters& parameters, const ProgressCallback& progress)
{
  return this->Diagram.Get({ parameters.Superlevel, parameters.Levels },
    [&]
    {
      RequireCubicalMemory(volume, parameters.Superlevel);
      return CubicalPersistence(volume, parameters, progress);
    });
}

}
