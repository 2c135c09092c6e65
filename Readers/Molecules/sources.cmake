isthmus_room(
  CLASSES
    vtkMacromoleculeReader
  SOURCES
    AtomSelection
    CovalentBonds
    GemmiAssembly
    GemmiStructure
    MMCIFBlock
    MacromoleculeReader
    MoleculeOutput
    PDBPieces
    PDBStream
    PQRFile
    XYZFile)

if (ISTHMUS_SANITIZE MATCHES undefined)
  # gemmi shifts negative characters and lets over-long numbers wrap, on purpose or not: harmless
  # with every compiler we know, and what it makes of them is checked.
  set_source_files_properties(
    Readers/Molecules/GemmiStructure.cxx Readers/Molecules/PDBPieces.cxx PROPERTIES
    COMPILE_OPTIONS "-fno-sanitize=shift,signed-integer-overflow")
endif ()
