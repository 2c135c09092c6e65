isthmus_room(
  CLASSES
    vtkOpenDXReader
    vtkOpenDXWriter
  SOURCES
    OpenDXObjects
    OpenDXReader
    OpenDXWriter)
