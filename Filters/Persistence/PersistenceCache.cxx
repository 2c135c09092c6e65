#include "Persistence/PersistenceCache.h"

#include "Persistence/CubicalPersistence.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>

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

}

VolumeView VolumeOf(vtkDataArray* scalars, vtkImageData* image)
{
  const int* n = image->GetDimensions();
  const std::array<std::int64_t, 3> dimensions{ n[0], n[1], n[2] };
  // GetVoidPointer copies arrays of one buffer for each component into another that they keep.
  if (scalars->HasStandardMemoryLayout() ||
    scalars->GetArrayType() == vtkAbstractArray::SoADataArrayTemplate)
  {
    switch (scalars->GetDataType())
    {
      vtkTemplateMacro(return TypedView<VTK_TT>(scalars->GetVoidPointer(0), dimensions));
      default:
        break;
    }
  }
  throw std::invalid_argument("The scalars are stored as " + std::string(scalars->GetClassName()) +
    ", but a plain array of numbers is needed: copy them to one first (with the Calculator, for "
    "instance).");
}

const VolumeStatistics& PersistenceCache::Statistics(
  vtkDataArray* scalars, const VolumeView& volume)
{
  // Times are unique, so another array at the same place in memory has another one.
  if (this->Scalars != scalars || this->Time != scalars->GetMTime() ||
    this->Dimensions != volume.Dimensions)
  {
    *this = PersistenceCache();
    this->Known = MeasureVolume(volume);
    this->Scalars = scalars;
    this->Time = scalars->GetMTime();
    this->Dimensions = volume.Dimensions;
  }
  return this->Known;
}

const CubicalDiagram& PersistenceCache::Pairs(
  const VolumeView& volume, const CubicalParameters& parameters, const ProgressCallback& progress)
{
  if (!this->Diagram || this->Parameters.Superlevel != parameters.Superlevel ||
    this->Parameters.Levels != parameters.Levels)
  {
    this->Diagram.reset();
    this->Diagram = CubicalPersistence(volume, parameters, progress);
    this->Parameters = parameters;
  }
  return *this->Diagram;
}

}
