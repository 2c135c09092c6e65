/**
 * @class   vtkOpenDXReader
 * @brief   reads potentials and other values on regular grids from OpenDX files, as APBS writes
 * them
 *
 * Files named .dx or .dx.gz (compression is found from the content). The output is a vtkImageData
 * with the point array `Potential`; APBS writes potentials in kT/e and lengths in angstrom, other
 * programs other things: the file's comments, which may name the unit, are kept. Source: OpenDX
 * User's Reference, appendix B.2 (native files).
 *
 * **Read:** objects of class gridpositions (counts, origin, delta rows), array (type float, double
 * or int; rank 0, or rank 1 with a shape, which becomes components; text, or raw bytes after
 * `binary`, `ieee`, `lsb` or `msb`) and field, attributes and comments. Values run with z fastest
 * in the file and are put in VTK's order, x fastest. float stays float, all else becomes double.
 * **Refused** with an error: values in another file, irregular positions, matrices, counts that
 * disagree, words where numbers belong, too few values or too many.
 *
 * **Deltas.** Along x, y, z: spacing and origin. Orthogonal but turned or reversed: also the
 * image's direction matrix. Skewed (off 90 degrees by more than 0.01): trilinear interpolation to
 * an orthogonal grid around the file's, with the deltas' lengths as spacings; nodes outside are NaN
 * and 0 in the point array `InsideMap`, and a warning says so.
 *
 * **Field data:** `Comments` (texts), `FieldName`, `Notes` (what the warnings said), when there are
 * any. Values that are not finite are kept and counted in a warning.
 *
 * **Errors** (missing, empty, truncated, of another kind, damaged): an error with file and line,
 * an empty output, and an error code of vtkErrorCode.
 *
 * **Cost.** One pass over the text, about 30 ns a number on one thread; the output, plus 32 MiB or
 * one grid plane of constant x. Each MPI rank reads the whole text and keeps its piece.
 */
#ifndef vtkOpenDXReader_h
#define vtkOpenDXReader_h

#include "vtkImageAlgorithm.h"
#include "vtkIsthmusReadersPotentialsModule.h" // for the export macro

#include <string> // for the name of the array

namespace isthmus
{
class OpenDXReader;
}

class VTKISTHMUSREADERSPOTENTIALS_EXPORT vtkOpenDXReader : public vtkImageAlgorithm
{
public:
  static vtkOpenDXReader* New();
  vtkTypeMacro(vtkOpenDXReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the file. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /// Which array of values to read of a file with several, from 0. Default: 0.
  vtkSetClampMacro(FieldIndex, int, 0, VTK_INT_MAX);
  vtkGetMacro(FieldIndex, int);
  ///@}

  ///@{
  /// Name of the output's array. Default: Potential.
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  /// 1 if the first word of the file is `object`, as in OpenDX files, else 0; the name plays no
  /// part. Says nothing on errors. Reads 1 MiB at most, unless more of it are comments.
  static int CanReadFile(const char* fileName);

protected:
  vtkOpenDXReader();
  ~vtkOpenDXReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

  char* FileName = nullptr;
  int FieldIndex = 0;
  std::string ArrayName = "Potential";

private:
  vtkOpenDXReader(const vtkOpenDXReader&) = delete;
  void operator=(const vtkOpenDXReader&) = delete;

  template <typename Body>
  int Try(vtkInformation* info, Body&& body);
  template <typename Array>
  void ReadValues(isthmus::OpenDXReader& file, vtkImageData* output);
};

#endif
