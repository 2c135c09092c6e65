/**
 * @class   vtkOpenDXReader
 * @brief   reads potentials and other values on regular grids from OpenDX files, as APBS writes
 * them
 *
 * Reads files named .dx or .dxbin, plain or .gz (whether numbers are text or binary and the
 * compression are detected from the content). The output is a
 * vtkImageData with the arrays of OutputArrayTable(); APBS writes potentials in kT/e and lengths in
 * angstrom. Other programs may write other quantities; the comments of the file, which may name the
 * unit, are kept. Source: OpenDX User's Reference, appendix B.2 (native files).
 *
 * **Read:** objects of class gridpositions (counts, origin, delta rows), array (type float, double
 * or int; rank 0, or rank 1 with a shape, which becomes components; text, or raw bytes after
 * `binary`, `ieee`, `lsb` or `msb`) and field, attributes and comments. In the file, z varies
 * fastest; values are reordered to VTK's order, in which x varies fastest. Float values stay float,
 * all others become double. **Refused** with an error: values in another file, irregular positions,
 * matrices, inconsistent counts, words instead of numbers, and too few or too many values.
 *
 * **Deltas.** Along x, y, z: spacing and origin. Orthogonal but rotated or reversed: also the
 * direction matrix of the image. Skewed (differing from 90 degrees by more than 0.01): trilinear
 * interpolation to an orthogonal grid around that of the file, with the lengths of the deltas as
 * spacings. Nodes outside have the value NaN; a warning reports this. Values that are not finite
 * are kept and counted in a warning.
 *
 * **Errors** (one message with file and line, an error code of vtkErrorCode, empty output): a file
 * that is missing, empty, truncated, damaged or of another kind. If a file ends with its values and
 * no line end follows, digits of the last one may be missing: such a file cannot be distinguished
 * from a whole one.
 *
 * **Cost.** Time: one pass over the text, on one thread. Memory: the output, plus 32 MiB or one
 * grid plane of constant x. Each MPI rank reads the whole text and keeps its piece.
 */
#ifndef vtkOpenDXReader_h
#define vtkOpenDXReader_h

#include "Core/OutputArrays.h"
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
  /// Index of the array of values to read if the file has several, from 0. Default: 0.
  vtkSetMacro(FieldIndex, int);
  vtkGetMacro(FieldIndex, int);
  ///@}

  ///@{
  /// Name of the output's array. Default: Potential.
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

  /// 1 if the first word of the file is "object", as in OpenDX files, otherwise 0; the name has no
  /// effect. Issues no messages on errors. Reads at most 1 MiB, unless comments are longer.
  static int CanReadFile(const char* fileName);

  /// The arrays that the reader adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

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
