# The project file for ParaView's superbuild: projects/isthmus.cmake there, by which the plugin gets into Kitware's ParaView. Its
# versions.cmake needs the lines that fill.py writes for a release.
# CGAL, GMP, MPFR, gemmi and ISA-L are no projects of the superbuild: they are those of the system that it runs on.
superbuild_add_project(isthmus
  DEPENDS paraview python3 boost eigen nlohmannjson bzip2 zlib cxx17
  LICENSE_FILES
    LICENSE
    Documentation/licences.md
  SPDX_LICENSE_IDENTIFIER
    GPL-3.0-or-later
  SPDX_COPYRIGHT_TEXT
    "Copyright (c) the authors of Isthmus"
  CMAKE_ARGS
    -DBUILD_SHARED_LIBS:BOOL=ON
    -DISTHMUS_PARAVIEW:BOOL=ON
    -DISTHMUS_TESTING:BOOL=OFF
    -DCMAKE_INSTALL_LIBDIR:PATH=lib)
