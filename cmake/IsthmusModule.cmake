# isthmus_add_module: one VTK module of a folder under Filters or Readers, from its CMakeLists.txt:
#
#   isthmus_add_module(Isthmus::FiltersImaging
#     [CLASSES vtkX ...]        VTK classes, wrapped and installed
#     [HEADERS X ...]           headers for C++ users, installed as <folder>/X.h
#     [FLAT_HEADERS X ...]      those of HEADERS that were installed as X.h before 1.0; Y=X: as Y.h
#     [SOURCES X ...]           implementation
#     [CGAL X ...]              sources that include CGAL
#     [VECTORISED X ...])       sources whose loops must vectorise
#
# all without extension. What it depends on is listed in the vtk.module beside it; its headers are
# included as "Imaging/X.h", those of its VTK classes as "vtkX.h", by it and by the modules that
# declare it.

# isthmus_module_files(OUT): all vtk.module files, the one list of modules.
function (isthmus_module_files out)
  file(GLOB files CONFIGURE_DEPENDS
    "${ISTHMUS_SOURCE_DIR}/Filters/*/vtk.module" "${ISTHMUS_SOURCE_DIR}/Readers/*/vtk.module")
  set("${out}" ${files} PARENT_SCOPE)
endfunction ()

# isthmus_vtk_components(OUT HEADING...): names of VTK's modules under these headings (DEPENDS,
# PRIVATE_DEPENDS, TEST_DEPENDS) of all vtk.module files.
function (isthmus_vtk_components out)
  isthmus_module_files(files)
  set(found)
  foreach (file IN LISTS files)
    set(heading)
    file(STRINGS "${file}" lines)
    foreach (line IN LISTS lines)
      if (line MATCHES "^[A-Z_]+$")
        set(heading "${line}")
      elseif (heading IN_LIST ARGN AND line MATCHES "^ +VTK::(.+)$")
        list(APPEND found "${CMAKE_MATCH_1}")
      endif ()
    endforeach ()
  endforeach ()
  list(REMOVE_DUPLICATES found)
  list(SORT found)
  set("${out}" ${found} PARENT_SCOPE)
endfunction ()

set(ISTHMUS_SOURCE_DIR "${CMAKE_CURRENT_LIST_DIR}/..")
get_filename_component(ISTHMUS_SOURCE_DIR "${ISTHMUS_SOURCE_DIR}" ABSOLUTE)

# Here, since the variables that it sets are needed in several folders.
find_package(CGAL 5.5 REQUIRED)

function (isthmus_add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 module "" ""
    "CLASSES;HEADERS;FLAT_HEADERS;SOURCES;CGAL;VECTORISED")
  if (module_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "isthmus_add_module: unknown arguments ${module_UNPARSED_ARGUMENTS}")
  endif ()
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  list(TRANSFORM module_HEADERS APPEND ".h")
  foreach (kind IN ITEMS SOURCES CGAL VECTORISED)
    list(TRANSFORM module_${kind} APPEND ".cxx")
  endforeach ()

  vtk_module_add_module(${name}
    CLASSES ${module_CLASSES}
    SOURCES ${module_SOURCES} ${module_CGAL} ${module_VECTORISED})
  vtk_module_compile_features(${name} PUBLIC cxx_std_17)

  # A folder of its own that holds nothing but this module's, so that "Imaging/X.h" is found by the
  # modules that declare this one, and by no others.
  set(include_dir "${CMAKE_CURRENT_BINARY_DIR}/include")
  file(MAKE_DIRECTORY "${include_dir}")
  file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}" "${include_dir}/${folder}" SYMBOLIC)
  vtk_module_include(${name} PUBLIC "$<BUILD_INTERFACE:${include_dir}>")
  vtk_module_install_headers(FILES ${module_HEADERS} SUBDIR "${folder}")

  # The names of before 1.0 forward to those of now until 1.1.
  foreach (name_before IN LISTS module_FLAT_HEADERS)
    string(REGEX REPLACE "^.*=" "" header "${name_before}")
    string(REGEX REPLACE "=.*$" "" name_before "${name_before}")
    set(forward "${CMAKE_CURRENT_BINARY_DIR}/flat/${name_before}.h")
    file(CONFIGURE OUTPUT "${forward}" CONTENT
"#pragma message(\"${name_before}.h is deprecated and will be removed in 1.1: include ${folder}/${header}.h\")
#include \"${folder}/${header}.h\"
")
    vtk_module_install_headers(FILES "${forward}")
  endforeach ()

  # Loops with square roots and comparisons vectorise only without errno and signals for them; values
  # (infinities and NaN too) are the same.
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    set_source_files_properties(${module_VECTORISED} PROPERTIES
      COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math")
  endif ()

  # Not linked as CGAL::CGAL, whose compile options would slow down everybody else's loops.
  if (module_CGAL)
    vtk_module_include(${name} SYSTEM PRIVATE ${CGAL_INCLUDE_DIRS})
    vtk_module_link(${name} PRIVATE ${MPFR_LIBRARIES} ${GMP_LIBRARIES})
    set_source_files_properties(${module_CGAL} PROPERTIES
      COMPILE_OPTIONS "-frounding-math"
      COMPILE_DEFINITIONS CGAL_NO_WARNINGS) # they go to stderr; ours go to VTK
  endif ()

  vtk_module_link(${name} PRIVATE "$<BUILD_INTERFACE:isthmus_compiler>")

  # A module that calls what it does not declare must not link, either. Sanitizers leave their own
  # symbols to the program.
  if (CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT ISTHMUS_SANITIZE AND NOT ISTHMUS_FUZZ)
    vtk_module_link_options(${name} PRIVATE "LINKER:--no-undefined")
  endif ()
endfunction ()
