isthmus_room(
  CLASSES
    vtkOpenDXReader
    vtkOpenDXWriter
  SOURCES
    OpenDXReader
    OpenDXWriter)
