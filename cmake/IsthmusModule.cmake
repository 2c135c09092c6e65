# The VTK module Isthmus::vtkIsthmus: every class and algorithm of the library. Each room (a folder
# under Filters or Readers) names its own files in its sources.cmake:
#
#   isthmus_room(
#     [CLASSES vtkX ...]        VTK classes, wrapped and installed
#     [HEADERS X ...]           headers for C++ users, installed beside those of the classes
#     [SOURCES X ...]           what they are made of
#     [CGAL X ...]              sources that include CGAL
#     [VECTORISED X ...])       sources whose loops must vectorise
#
# all without extension and folder.

# Adds a room's files to the lists of the caller: classes, sources, cgal_sources, vectorised_sources
# (the last two are in `sources`, too), headers and rooms.
function (isthmus_room)
  cmake_parse_arguments(PARSE_ARGV 0 room "" "" "CLASSES;HEADERS;SOURCES;CGAL;VECTORISED")
  if (room_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "isthmus_room: not a list of its own: ${room_UNPARSED_ARGUMENTS}")
  endif ()
  file(RELATIVE_PATH folder "${CMAKE_CURRENT_SOURCE_DIR}" "${CMAKE_CURRENT_LIST_DIR}")
  list(TRANSFORM room_CLASSES PREPEND "${folder}/")
  list(TRANSFORM room_HEADERS REPLACE "(.+)" "${folder}/\\1.h")
  foreach (kind IN ITEMS SOURCES CGAL VECTORISED)
    list(TRANSFORM room_${kind} PREPEND "${folder}/")
    list(TRANSFORM room_${kind} APPEND ".cxx")
  endforeach ()
  set(rooms ${rooms} "${folder}" PARENT_SCOPE)
  set(classes ${classes} ${room_CLASSES} PARENT_SCOPE)
  set(headers ${headers} ${room_HEADERS} PARENT_SCOPE)
  set(sources ${sources} ${room_SOURCES} ${room_CGAL} ${room_VECTORISED} PARENT_SCOPE)
  set(cgal_sources ${cgal_sources} ${room_CGAL} PARENT_SCOPE)
  set(vectorised_sources ${vectorised_sources} ${room_VECTORISED} PARENT_SCOPE)
endfunction ()

file(GLOB room_files CONFIGURE_DEPENDS
  "${CMAKE_CURRENT_SOURCE_DIR}/Filters/*/sources.cmake"
  "${CMAKE_CURRENT_SOURCE_DIR}/Readers/*/sources.cmake")
foreach (room_file IN LISTS room_files)
  include("${room_file}")
endforeach ()

# Loops with square roots and comparisons vectorise only without errno and signals for them; values
# (infinities and NaN too) are the same.
if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  set_source_files_properties(${vectorised_sources} PROPERTIES
    COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math")
endif ()

vtk_module_add_module(Isthmus::vtkIsthmus
  CLASSES ${classes}
  SOURCES ${sources}
  NOWRAP_HEADERS ${headers})

# Public, since the wrappers include every class by its bare name; installed headers lie flat.
foreach (room IN LISTS rooms)
  vtk_module_include(Isthmus::vtkIsthmus
    PUBLIC "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${room}>")
endforeach ()
vtk_module_compile_features(Isthmus::vtkIsthmus PUBLIC cxx_std_17)

# VTK's own build (remote module) has no target of ours for warnings and sanitizers.
if (TARGET isthmus_compiler)
  vtk_module_link(Isthmus::vtkIsthmus PRIVATE "$<BUILD_INTERFACE:isthmus_compiler>")
endif ()

find_package(BZip2 REQUIRED)
vtk_module_link(Isthmus::vtkIsthmus PRIVATE BZip2::BZip2)

# Faster than zlib at gzip, but made for few processors: zlib stays where it is missing.
find_path(ISAL_INCLUDE_DIR isa-l/igzip_lib.h)
find_library(ISAL_LIBRARY isal)
if (ISAL_INCLUDE_DIR AND ISAL_LIBRARY)
  vtk_module_include(Isthmus::vtkIsthmus SYSTEM PRIVATE "${ISAL_INCLUDE_DIR}")
  vtk_module_link(Isthmus::vtkIsthmus PRIVATE "${ISAL_LIBRARY}")
  vtk_module_definitions(Isthmus::vtkIsthmus PRIVATE ISTHMUS_HAS_ISAL)
endif ()

# Headers only; Debian's gemmi-dev has no CMake package. Its CIF grammar is built on PEGTL.
find_path(GEMMI_INCLUDE_DIR gemmi/pdb.hpp REQUIRED)
find_path(PEGTL_INCLUDE_DIR tao/pegtl.hpp REQUIRED)
vtk_module_include(Isthmus::vtkIsthmus SYSTEM PRIVATE
  "${GEMMI_INCLUDE_DIR}" "${PEGTL_INCLUDE_DIR}")

find_package(Eigen3 REQUIRED NO_MODULE)
vtk_module_link(Isthmus::vtkIsthmus PRIVATE "$<BUILD_INTERFACE:Eigen3::Eigen>")

# Not linked as CGAL::CGAL, whose compile options would slow down everybody else's loops.
find_package(CGAL 5.5 REQUIRED)
vtk_module_include(Isthmus::vtkIsthmus SYSTEM PRIVATE ${CGAL_INCLUDE_DIRS})
vtk_module_link(Isthmus::vtkIsthmus PRIVATE ${MPFR_LIBRARIES} ${GMP_LIBRARIES})
set_source_files_properties(${cgal_sources} PROPERTIES
  COMPILE_OPTIONS "-frounding-math"
  COMPILE_DEFINITIONS CGAL_NO_WARNINGS) # they go to stderr; ours go to VTK
