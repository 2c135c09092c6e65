#include "Files/GridInformation.h"

#include "Files/ReaderError.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <string>

namespace isthmus
{

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

}

void Describe(const GridInformation& grid, vtkInformation* info)
{
  int whole[6];
  for (std::size_t a = 0; a < 3; ++a)
  {
    whole[2 * a] = 0;
    whole[2 * a + 1] = static_cast<int>(grid.Dimensions[a] - 1);
  }
  info->Set(Pipeline::WHOLE_EXTENT(), whole, 6);
  info->Set(vtkDataObject::SPACING(), grid.Spacing.data(), 3);
  info->Set(vtkDataObject::ORIGIN(), grid.Origin.data(), 3);
  info->Set(vtkDataObject::DIRECTION(), grid.Direction.data(), 9);
}

void RequireUnchanged(const GridInformation& grid, vtkInformation* info, const char* path)
{
  vtkNew<vtkInformation> now;
  Describe(grid, now);
  const auto same = [info, now = now.Get()](auto* key, int count)
  { return std::equal(now->Get(key), now->Get(key) + count, info->Get(key)); };
  if (!same(Pipeline::WHOLE_EXTENT(), 6) || !same(vtkDataObject::SPACING(), 3) ||
    !same(vtkDataObject::ORIGIN(), 3) || !same(vtkDataObject::DIRECTION(), 9))
  {
    throw ReaderError(ReaderFailure::BadRequest,
      std::string(path) +
        ": the file has changed since its header was read: reload it (Reload Files).");
  }
}

void StartImage(vtkInformation* info, vtkImageData* image)
{
  int extent[6];
  info->Get(Pipeline::UPDATE_EXTENT(), extent);
  image->SetExtent(extent);
  image->SetSpacing(info->Get(vtkDataObject::SPACING()));
  image->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  image->SetDirectionMatrix(info->Get(vtkDataObject::DIRECTION()));
}

}
