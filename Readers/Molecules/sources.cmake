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
  # gemmi shifts negative characters (names of residues that are no ASCII), which every compiler does
  # alike. Its functions are inline: all files that have them are compiled alike.
  set_source_files_properties(
    Readers/Molecules/GemmiAssembly.cxx Readers/Molecules/GemmiStructure.cxx
    Readers/Molecules/MMCIFBlock.cxx Readers/Molecules/PDBPieces.cxx PROPERTIES
    COMPILE_OPTIONS "-fno-sanitize=shift")
endif ()
