/**
 * @file HalfFaceMatching.h
 * @brief Finds, for each half face of a mesh, the half face of the cell beyond it. Used by
 * CompactCombinatorialMap only.
 *
 * Two half faces match if they have the same vertices. O(half faces), in parallel; the result does
 * not depend on the number of threads.
 */
#ifndef isthmus_HalfFaceMatching_h
#define isthmus_HalfFaceMatching_h

#include "CellComplex/DartMap.h"
#include "CellComplex/MeshError.h"
#include "Core/Progress.h"

#include <array>
#include <memory>
#include <mutex>

namespace isthmus
{

/// Fills the H2D table of a map whose blocks and Cv2V are set.
/// @throws MeshError.
template <typename Id>
class HalfFaceMatching
{
public:
  explicit HalfFaceMatching(DartMap<Id>& map);
  void Run(const ProgressCallback& progress);

private:
  using Map = DartMap<Id>;
  using HalfFace = typename Map::HalfFace;
  using Reason = MeshError::Reason;

  /// A half face in its bucket: its number, and 32 bits that depend on the set of its vertices.
  struct Entry
  {
    HalfFace Half;
    std::uint32_t Hash;
  };
  struct Key
  {
    std::size_t SmallestVertex;
    std::uint32_t Hash;
  };
  /// Two half faces that cannot be joined.
  struct Clash
  {
    Reason Why;
    HalfFace First, Second;
  };
  /// The relation of two half faces: their vertices differ, agree in the same direction, or agree
  /// in opposite directions, as required. In the last case also the position, in the second half
  /// face, of the first dart of the first.
  struct Alignment
  {
    bool SameVertices;
    bool Opposite;
    unsigned Position;
  };

  template <typename Visit>
  void ForEachHalfFace(std::int64_t chunk, Visit&& visit) const;
  void CountChunk(std::int64_t chunk);
  void DistributeChunk(std::int64_t chunk);
  std::size_t ConvertCountsToOffsets();
  void MatchBuckets(std::int64_t first, std::int64_t last);
  void MatchBucket(std::size_t bucket, std::vector<std::uint32_t>& slots);
  void Join(HalfFace a, HalfFace b, const Alignment& alignment);
  Alignment Compare(HalfFace a, HalfFace b) const;
  bool SameVertices(HalfFace a, HalfFace b) const;
  void RecordClash(const Clash& clash);
  void ThrowFirstClashes();
  std::size_t Bucket(std::size_t vertex) const { return vertex >> this->BucketShift; }
  std::size_t Smallest(HalfFace half) const;

  Map& Mesh;
  std::int64_t Chunks;
  std::size_t Buckets;
  unsigned BucketShift = 0;
  std::vector<Id> Places; // [chunk * Buckets + bucket]
  std::vector<std::size_t> BucketStarts;
  std::unique_ptr<Entry[]> Entries;
  std::mutex ClashMutex;
  std::vector<Clash> Clashes;
};

}

#endif
