isthmus_room(
  SOURCES
    ByteSource
    CompressedSource
    PlainFile
    SkewedLattice
    StridedCopy)
