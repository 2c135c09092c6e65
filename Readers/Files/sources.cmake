isthmus_room(
  SOURCES
    CompressedSource
    OpenByteSource
    PlainFile
    SkewedLattice
    StridedCopy
    VoxelLattice)
