/**
 * @file DiffusionImage.h
 * @brief Converts a vtkImageData to volumes of the diffusion algorithms, and back.
 */
#ifndef isthmus_DiffusionImage_h
#define isthmus_DiffusionImage_h

#include "Core/Progress.h"
#include "Imaging/DiffusionGrid.h"
#include "Imaging/DomainDecomposition.h"

#include <vtkAOSDataArrayTemplate.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;

namespace isthmus
{

/// This rank's part of an image, with values of type T and a halo. Lives during one RequestData.
template <typename T>
class DiffusionImage
{
public:
  using Array = vtkAOSDataArrayTemplate<T>;

  /// @pre `input` covers the rank's own part; the halo comes from the other ranks.
  /// @throws std::invalid_argument for a spacing that is not positive where there is more than one
  /// node.
  DiffusionImage(vtkImageData* input, vtkImageData* output, const DomainDecomposition& parts,
    bool voxelUnits, ProgressCallback progress);

  vtkImageData* GetInput() const { return this->Input; }
  const DiffusionGrid<T>& GetGrid() const { return this->Grid; }
  const ProgressCallback& GetProgress() const { return this->Progress; }

  /// A new volume with the values of a point array of the input, with its name. An array that is
  /// missing or of the wrong size throws std::invalid_argument; values that are not
  /// finite throw std::invalid_argument, or, if `mask` is true, are replaced and remembered (those
  /// of the last such array).
  vtkSmartPointer<Array> Copy(vtkDataArray* array, bool mask);

  /// A new volume whose values are yet to be written.
  vtkSmartPointer<Array> NewVolume(const std::string& name) const;

  /// A new volume like `volume`, with the same values and another name.
  vtkSmartPointer<Array> Duplicate(Array* volume, const std::string& name) const;

  /// Copies a volume to the output, without its halo, and restores masked values.
  void AddResult(Array* volume, bool active);

  /// Adds numbers to the output's field data.
  void AddFieldData(const std::string& name, const std::vector<double>& values);

  /// Adds a sentence to the output's field data.
  void AddFieldText(const std::string& name, const std::string& text);

private:
  void CheckArray(vtkDataArray* array) const;
  void RefuseInvalid(const T* values) const;
  void Mask(T* values);

  vtkImageData* Input;
  vtkImageData* Output;
  const DomainDecomposition& Parts;
  DiffusionGrid<T> Grid;
  ProgressCallback Progress;
  struct Masked
  {
    std::int64_t Node;
    T Value;
  };
  std::vector<Masked> Invalid;
};

}

#endif
