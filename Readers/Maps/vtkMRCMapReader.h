/**
 * @class   vtkMRCMapReader
 * @brief   reads density maps of electron microscopy and crystallography: MRC2014, CCP4, EMDB
 *
 * Files named .mrc .map .ccp4 .mrcs .rec .ali .st, plain, gzip- or bzip2-compressed (detected from
 * the content, not from the name). The output is a vtkImageData in angstrom with axes x, y, z.
 * Sources: Cheng et al. 2015, doi:10.1016/j.jsb.2015.04.002; the CCP4 map format; IMOD for modes 16
 * and 101.
 *
 * **Values.** Mode 0: signed char (unsigned char where IMOD's header flag says so), 1: short,
 * 2: float, 3: short with 2 components, 4: float with 2 components (Fourier transforms, as stored,
 * no Hermitian completion), 6: unsigned short, 12 (half precision): float, 16: unsigned char with
 * 3 components, 101 (4 bit): unsigned char. Either byte order.
 *
 * **Position.** Spacing is CELLA / MX, MY, MZ; a file's axis order MAPC, MAPR, MAPS is undone. The
 * first node lies at ORIGIN if any component of it is not zero, otherwise at NXSTART, NYSTART,
 * NZSTART spacings, but never at the sum of both; this is the rule of ChimeraX. CCP4's skew
 * transformation (LSKFLG 1, a rotation SKWMAT and a translation SKWTRN) is applied in addition:
 * x_world = SKWMAT^-1 x_map + SKWTRN, as the direction matrix and origin of the image. The image's
 * extent starts at 0.
 *
 * **Cells that are not orthogonal** (with an angle that differs from 90 degrees by more than 0.01)
 * cannot be represented by a vtkImageData directly. NonOrthogonalCell chooses: resampling (the
 * default), which adds the point array `InsideMap`, or the nodes as stored with right angles, which
 * distorts shapes. A warning and the field data Notes state which of them was used.
 *
 * **No data.** A value far from all others that stands for "no data", such as -9999 or 1e35
 * (NoData.h), is replaced by 0, as outside the mask of masked maps, and the point array `NoData`
 * marks it; a note says so. Where
 * only a piece of a map is read, the decision is made on this piece.
 *
 * **Stacks.** Space groups 401-630 are stacks of volumes of MZ sections. A file is a stack of
 * images if it has space group 0 and MZ 1, is named .mrcs, or is named .st or .ali and has space
 * group 0. Everything else is one volume, even with space group 0, which ChimeraX and cryoSPARC
 * write for volumes.
 *
 * OutputArrayTable() lists the arrays and the field data. `RecommendedLevel` is that of
 * `emd-NNNN.xml`, where it lies beside `emd_NNNN.map`.
 *
 * **Damaged headers** are read as far as they can be interpreted; each value that had to be
 * replaced is listed in a warning and in `Repairs`. With Strict on, the first such value is an
 * error. For files that cannot be read (missing, empty, truncated, of another kind), an error names
 * the file and what is wrong, the output is empty, and an error code of vtkErrorCode is set.
 *
 * **Cost.** Reading takes one pass over the required bytes, in parallel, without a copy for float
 * maps in the byte order of this machine. Pieces (update extents) and CropExtent leave the rest of
 * a plain file unread. A compressed file is decompressed up to the last node needed (twice with
 * SampleRate), the first time from its beginning and later, as far as it is known by then, from
 * less than 64 MiB before the first node needed (bzip2 only on several threads). Memory: the
 * output, plus a few MiB (up to 32 MiB for compressed files, and 12 MiB for the index of one, 60
 * MiB by bzip2), plus the nodes read when resampling.
 */
#ifndef vtkMRCMapReader_h
#define vtkMRCMapReader_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Maps/MRCOptions.h"
#include "vtkImageAlgorithm.h"
#include "vtkIsthmusReadersMapsModule.h" // for the export macro

#include <string> // for the last warning

namespace isthmus
{
class MRCMap;
}

class VTKISTHMUSREADERSMAPS_EXPORT vtkMRCMapReader : public vtkImageAlgorithm
{
public:
  static vtkMRCMapReader* New();
  vtkTypeMacro(vtkMRCMapReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the file. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /// Index of the volume or image in a stack, from 0. Default -1: all images of an image stack, one
  /// above the other, or the first volume of a volume stack.
  ISTHMUS_PARAMETER(VolumeIndex, int);
  ///@}

  ///@{
  /// First and last node to read along x, y, z of the map as stored, counted from 0; a last node of
  /// -1 stands for the end of the map. Default: 0 -1 0 -1 0 -1, everything. Nodes that the map
  /// lacks are an error.
  void SetCropExtent(int x0, int x1, int y0, int y1, int z0, int z1);
  void SetCropExtent(const int extent[6]);
  int* GetCropExtent() VTK_SIZEHINT(6) { return this->Parameters.CropExtent.data(); }
  ///@}

  ///@{
  /// Bin the map: read means of n nodes along x, y, z, from the first of the crop, as floats at the
  /// middle of these nodes. A rest of less than n nodes at the end is dropped. Voxels with several
  /// components (modes 3, 4, 16) are not averaged, but every n-th of them is read. Default: 1 1 1.
  ISTHMUS_PARAMETER_VECTOR3(SampleRate, int);
  ///@}

  enum NonOrthogonalCellMode
  {
    Resample = 0,
    KeepCellAxes = 1
  };

  ///@{
  /// Treatment of a cell whose angles are not 90 degrees. Resample (default): trilinear
  /// interpolation to an orthogonal grid around the map, with the lengths of the cell's steps as
  /// spacings. KeepCellAxes: the nodes are used as stored, with right angles, so shapes are
  /// distorted.
  ISTHMUS_PARAMETER(NonOrthogonalCell, int);
  void SetNonOrthogonalCellToResample() { this->SetNonOrthogonalCell(Resample); }
  void SetNonOrthogonalCellToKeepCellAxes() { this->SetNonOrthogonalCell(KeepCellAxes); }
  ///@}

  ///@{
  /// Refuse files whose header needs repair. Default: off.
  vtkSetMacro(Strict, bool);
  vtkGetMacro(Strict, bool);
  vtkBooleanMacro(Strict, bool);
  ///@}

  /// 1 if the content of `fileName` begins like a map (decompressed, if necessary), or if its name
  /// ends like that of a map, so that reading it reports what is wrong; else 0. Issues no messages
  /// on errors. Reads 1 KB.
  virtual int CanReadFile(const char* fileName);

  /// The arrays that the reader adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkMRCMapReader();
  ~vtkMRCMapReader() override;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

  char* FileName = nullptr;
  isthmus::MRCOptions Parameters;
  bool Strict = false;

private:
  vtkMRCMapReader(const vtkMRCMapReader&) = delete;
  void operator=(const vtkMRCMapReader&) = delete;

  template <typename Body>
  int Try(vtkInformation* info, Body&& body);
  void ReportNotes(const isthmus::MRCMap& map);
  void ReadArrays(isthmus::MRCMap& map, const int extent[6], vtkImageData* output);

  std::string LastWarning; // not repeated while the same file is read again
};

#endif
