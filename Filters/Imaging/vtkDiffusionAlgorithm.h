/**
 * @class vtkDiffusionAlgorithm
 * @brief Base of the iterated volume filters: one scalar image in, images of floating type out.
 *
 * Input: vtkImageData with a single-component point array of any type, spacing and extent (one
 * slice or one row, too); by default the active scalars, see SetInputArrayToProcess. Output: the
 * input with every other array, field data, origin, spacing and direction; results are float for
 * float and for integers of up to 16 bits, otherwise double. The input is never changed.
 *
 * Values that are not finite are refused, with the position of the first one. With MaskInvalid they
 * are replaced by a value of their neighbours during the computation, and are unchanged in the
 * output.
 *
 * On several ranks of Controller every rank works on its part of the image and exchanges a halo
 * before each evaluation, so all ranks must update the filter and together request the whole image.
 * Results do not depend on the number of ranks or threads. On one rank the filter always computes,
 * and returns, the whole image.
 */
#ifndef vtkDiffusionAlgorithm_h
#define vtkDiffusionAlgorithm_h

#include "vtkImageAlgorithm.h"
#include "vtkIsthmusFiltersImagingModule.h" // for the export macro

class vtkDataArray;
class vtkImageData;
class vtkMultiProcessController;

#include <array> // for extents

namespace isthmus
{
template <typename T>
class DiffusionImage;
class DomainDecomposition;
}

class VTKISTHMUSFILTERSIMAGING_EXPORT vtkDiffusionAlgorithm : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkDiffusionAlgorithm, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Return values that are not finite unchanged instead of refusing them.
  vtkSetMacro(MaskInvalid, bool);
  vtkGetMacro(MaskInvalid, bool);
  vtkBooleanMacro(MaskInvalid, bool);
  ///@}

  ///@{
  /// The processes that share the image; null for this one alone. Default the global controller.
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

protected:
  vtkDiffusionAlgorithm();
  ~vtkDiffusionAlgorithm() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Number of nodes that the computation needs around the part of a rank; must not throw.
  virtual int HaloWidth() = 0;

  ///@{
  /// Runs the computation; results are passed to AddResult of the image.
  virtual void Process(isthmus::DiffusionImage<float>& image) = 0;
  virtual void Process(isthmus::DiffusionImage<double>& image) = 0;
  ///@}

  /// The input array (Core/ImageScalars.h); null on a rank without nodes.
  vtkDataArray* ChosenScalars(vtkImageData* image);

  /// Lengths in units of the smallest spacing (on) or in the data's unit (off). A property of the
  /// filters whose parameters are lengths.
  bool VoxelUnits = true;

private:
  bool IsParallel() const;

  /// The nodes of the delivered input that this rank has to compute.
  std::array<int, 6> OwnPart(
    vtkImageData* input, vtkInformation* request, const std::array<int, 6>& whole);

  /// The input array; throws on all ranks if one of them has none.
  vtkDataArray* ScalarsOnAllRanks(vtkImageData* image, const isthmus::DomainDecomposition& parts);

  template <typename T>
  void Compute(
    vtkImageData* input, vtkImageData* output, const isthmus::DomainDecomposition& parts);

  vtkDiffusionAlgorithm(const vtkDiffusionAlgorithm&) = delete;
  void operator=(const vtkDiffusionAlgorithm&) = delete;

  vtkMultiProcessController* Controller = nullptr;
  bool MaskInvalid = false;
};

#endif
