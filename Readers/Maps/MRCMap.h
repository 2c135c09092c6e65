/**
 * @file MRCMap.h
 * @brief An open map file: its contents, the selected part of it, and reading.
 *
 *     isthmus::MRCMap map("emd_5043.map.gz");
 *     map.Select({});                                  // everything
 *     std::vector<unsigned char> values(map.OutputBytes(map.OutputBox()));
 *     std::vector<unsigned char> inside(values.size() / map.OutputVoxel().Bytes);
 *     map.Read(map.OutputBox(), values.data(), inside.data(), {});
 */
#ifndef isthmus_MRCMap_h
#define isthmus_MRCMap_h

#include "Files/ByteSource.h"
#include "Files/VoxelLattice.h"
#include "Maps/MRCGeometry.h"
#include "Maps/MRCHeader.h"
#include "Maps/MRCOptions.h"
#include "Maps/MRCVoxels.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace isthmus
{

/// One open map. It cannot be copied, and may be used by only one thread at a time (it starts its
/// own threads).
class MRCMap
{
public:
  /// Reads the header (1 KB).
  /// @throws ReaderError with a message that begins with the path.
  explicit MRCMap(const std::string& path);

  const MRCHeader& Header() const { return this->Head; }
  const MRCStack& Stack() const { return this->Sections; }
  std::string Compression() const { return this->Source->Compression(); }

  /// Selects the part for Grid(), OutputBox() and Read(). Must be called before them.
  /// @throws ReaderError (BadRequest) when the file has no such volume or nodes.
  void Select(const MRCOptions& options);

  /// The orthogonal grid of the output; node 0 is the first selected one.
  const VoxelLattice& Grid() const { return this->Target; }
  /// True when the cell is not orthogonal and Read() interpolates.
  bool Resampled() const { return this->Interpolated; }
  /// True when Read() computes means (MRCOptions::SampleRate).
  bool Averaged() const { return this->Means; }
  /// The type of a voxel in memory that Read() produces.
  const MRCVoxelType& OutputVoxel() const { return this->Voxel; }
  /// All nodes of Grid().
  NodeBox OutputBox() const;
  /// Bytes of the values of a box of Grid(); the largest number if 64 bits overflow.
  std::uint64_t OutputBytes(const NodeBox& box) const;

  /**
   * Fills `out`, with x varying fastest, with the nodes `box` of Grid(), in the memory format of
   * OutputVoxel(), and `inside` (needed only if Resampled()) with 1, or 0 outside the map. The
   * result is bitwise the same for any box and number of threads.
   *
   * @pre `box` lies in OutputBox() and is not empty.
   *
   * Time: one pass over the bytes of the
   * box (see MRCVoxels.h); memory if Resampled(): the nodes of the map that `box` needs.
   * @throws ReaderError (Truncated, Damaged, CannotRead), std::bad_alloc and Cancelled.
   */
  void Read(const NodeBox& box, void* out, unsigned char* inside, const ProgressCallback& progress);

  /**
   * Plain files are checked when they are opened. A compressed file with a suspicious expansion
   * ratio is decompressed once to check its size, before memory is allocated according to its
   * header; returns true if that was done.
   * @throws ReaderError (Truncated) if the file has too few bytes to fill `bytes` of memory.
   */
  bool CheckBeforeAllocating(std::uint64_t bytes, const ProgressCallback& progress);

private:
  [[noreturn]] void Reject(const std::string& sentence) const;
  VoxelLattice SelectVolume(const MRCOptions& options);
  void SelectNodes(const MRCOptions& options, const VoxelLattice& whole);
  void ReadNodes(const NodeBox& box, void* out, const ProgressCallback& progress);
  std::optional<double> FindNoData(const MRCSelection& part, const ProgressCallback& progress);

  std::unique_ptr<ByteSource> Source;
  MRCHeader Head;
  MRCStack Sections;
  MRCVoxelLayout Layout;
  MRCSelection Nodes;
  VoxelLattice Lattice; ///< of the selected nodes
  VoxelLattice Target;
  MRCVoxelType Voxel; ///< of the output
  bool Interpolated = false;
  bool Means = false;
};

/// True for a file with the ending of a map, except geographic maps (PCRaster, OziExplorer) that
/// have the ending .map, too. Never throws.
bool IsNamedAsMRCFile(const std::string& path);

/// True if the file at `path` begins like a map, compressed or not. Never throws.
bool LooksLikeMRCFile(const std::string& path);

}

#endif
