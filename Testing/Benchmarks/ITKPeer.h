/**
 * @file ITKPeer.h
 * @brief Diffusion by ITK (libinsighttoolkit5-dev), for comparison.
 */
#ifndef isthmus_ITKPeer_h
#define isthmus_ITKPeer_h

#include <itkCurvatureFlowImageFilter.h>
#include <itkGradientAnisotropicDiffusionImageFilter.h>
#include <itkImage.h>
#include <itkImportImageFilter.h>

#include <cstddef>

namespace isthmus::peers
{

using ITKImage = itk::Image<float, 3>;

/// n^3 floats of the caller as an ITK image.
inline ITKImage::Pointer ITKView(float* values, int n)
{
  using Import = itk::ImportImageFilter<float, 3>;
  const auto import = Import::New();
  Import::SizeType size;
  size.Fill(static_cast<itk::SizeValueType>(n));
  Import::RegionType region;
  region.SetSize(size);
  import->SetRegion(region);
  import->SetImportPointer(values, region.GetNumberOfPixels(), false);
  import->Update();
  return import->GetOutput();
}

/// Perona and Malik's diffusion, which edge stopping of order 0 is.
inline itk::GradientAnisotropicDiffusionImageFilter<ITKImage, ITKImage>::Pointer ITKEdgeStopping()
{
  const auto filter = itk::GradientAnisotropicDiffusionImageFilter<ITKImage, ITKImage>::New();
  filter->SetConductanceParameter(1.0);
  return filter;
}

/// Levels move by their mean curvature, as in geometric flow of order 0.
inline itk::CurvatureFlowImageFilter<ITKImage, ITKImage>::Pointer ITKGeometricFlow()
{
  return itk::CurvatureFlowImageFilter<ITKImage, ITKImage>::New();
}

/// `iterations` explicit steps, each of the longest stable length.
template <typename Filter>
void RunITK(const Filter& filter, const ITKImage::Pointer& image, unsigned int iterations)
{
  filter->SetInput(image);
  filter->SetTimeStep(0.0625); // 1 / 2^(dimension + 1)
  filter->SetNumberOfIterations(iterations);
  filter->Modified();
  filter->Update();
}

}

#endif
