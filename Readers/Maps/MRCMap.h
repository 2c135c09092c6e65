/**
 * @file MRCMap.h
 * @brief A map file, opened: what it holds, which part of it is wanted, and the reading of it.
 *
 *     isthmus::MRCMap map("emd_5043.map.gz");
 *     map.Select({});                                  // everything
 *     std::vector<unsigned char> values(map.OutputBytes(map.OutputBox()));
 *     std::vector<unsigned char> inside(values.size() / map.Header().Voxel.Bytes);
 *     map.Read(map.OutputBox(), values.data(), inside.data(), {});
 */
#ifndef isthmus_MRCMap_h
#define isthmus_MRCMap_h

#include "Files/ByteSource.h"
#include "Files/VoxelLattice.h"
#include "Maps/MRCGeometry.h"
#include "Maps/MRCHeader.h"
#include "Maps/MRCVoxels.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace isthmus
{

/// Which part of a map is wanted, and how.
struct MRCOptions
{
  /// Volume or image of a stack, from 0; -1: all images of an image stack, one above the other
  /// along the sections' axis, or the first volume.
  int VolumeIndex = -1;
  /// First and last node along x, y, z of the volume as stored; a last node of -1 is the end.
  std::array<int, 6> CropExtent{ 0, -1, 0, -1, 0, -1 };
  /// Every n-th node along x, y, z, from the first of the crop; no averaging.
  std::array<int, 3> SampleRate{ 1, 1, 1 };
  /// What a cell with angles off 90 degrees becomes: resampled to an orthogonal grid, or its nodes
  /// as they are with right angles instead (the shape is then wrong).
  bool KeepCellAxes = false;
};

/// One open map. Not copied; used by one thread at a time (it starts its own).
class MRCMap
{
public:
  /// Reads the header (1 KB).
  /// @throws ReaderError with a message that begins with the path.
  explicit MRCMap(const std::string& path);

  const MRCHeader& Header() const { return this->Head; }
  const MRCStack& Stack() const { return this->Sections; }
  std::string Compression() const { return this->Source->Compression(); }

  /// Chooses what Grid(), OutputBox() and Read() are about. Call it before them.
  /// @throws ReaderError (BadRequest) when the file has no such volume or nodes.
  void Select(const MRCOptions& options);

  /// The orthogonal grid of the output; node 0 is the first selected one.
  const VoxelLattice& Grid() const { return this->Target; }
  /// True when the cell is not orthogonal and Read() interpolates.
  bool Resampled() const { return this->Interpolated; }
  /// All nodes of Grid().
  NodeBox OutputBox() const;
  /// Bytes of the values of a box of Grid(); the largest number when 64 bits overflow.
  std::uint64_t OutputBytes(const NodeBox& box) const;

  /**
   * Fills `out`, x fastest, with the nodes `box` of Grid(), as Header().Voxel has them in memory,
   * and `inside` (needed only when Resampled()) with 1, or 0 outside the map. Bit for bit the same
   * for any box and number of threads.
   *
   * @pre `box` lies in OutputBox() and is not empty.
   *
   * Time: one pass over the bytes of the
   * box (see MRCVoxels.h); memory when Resampled(): the nodes of the map that `box` needs.
   * @throws ReaderError (Truncated, Damaged, CannotRead), std::bad_alloc and Cancelled.
   */
  void Read(const NodeBox& box, void* out, unsigned char* inside, const ProgressCallback& progress);

  /**
   * Plain files have been checked when opened; a compressed one that would have to expand
   * suspiciously is decompressed once for its size, before memory is taken on its word: true when
   * that was done.
   * @throws ReaderError (Truncated) unless the file has the bytes that `bytes` of memory would be
   * filled from.
   */
  bool CheckBeforeAllocating(std::uint64_t bytes, const ProgressCallback& progress);

private:
  [[noreturn]] void Refuse(const std::string& sentence) const;
  VoxelLattice SelectVolume(const MRCOptions& options);
  void SelectNodes(const MRCOptions& options, const VoxelLattice& whole);
  void ReadNodes(const NodeBox& box, void* out, const ProgressCallback& progress);

  std::unique_ptr<ByteSource> Source;
  MRCHeader Head;
  MRCStack Sections;
  MRCVoxelLayout Layout;
  MRCSelection Nodes;
  VoxelLattice Lattice; ///< of the selected nodes
  VoxelLattice Target;
  bool Interpolated = false;
};

/// True when the file at `path` begins as a map does, compressed or not. Never throws.
bool LooksLikeMRCFile(const std::string& path);

}

#endif
