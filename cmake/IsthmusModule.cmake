# isthmus_add_module: adds the VTK module of a folder under Filters or Readers; called in its
# CMakeLists.txt:
#
#   isthmus_add_module(Isthmus::FiltersImaging
#     [CLASSES vtkX ...]        VTK classes, wrapped and installed
#     [HEADERS X ...]           headers for C++ users, installed as <folder>/X.h
#     [SOURCES X ...]           implementation
#     [CGAL X ...]              sources that include CGAL
#     [LARGE X ...]             those that take the compiler more than a gigabyte
#     [VECTORISED X ...])       sources whose loops must be vectorised
#
# File names have no extension. SOURCES whose names end in Windows, Mac, Linux or Posix (all but Windows) are
# compiled on that system alone. Dependencies are listed in the vtk.module of the same folder; the
# module itself and those that declare it as a dependency include its headers as "Imaging/X.h",
# those of its VTK classes as "vtkX.h".

# isthmus_module_files(OUT): all vtk.module files; they define the list of modules. Those with large
# sources come first: Ninja compiles in this order as far as dependencies allow.
function (isthmus_module_files out)
  file(GLOB files CONFIGURE_DEPENDS
    "${ISTHMUS_SOURCE_DIR}/Filters/*/vtk.module" "${ISTHMUS_SOURCE_DIR}/Readers/*/vtk.module")
  set(large)
  foreach (folder IN ITEMS Tetrahedra Contouring Remeshing)
    list(APPEND large "${ISTHMUS_SOURCE_DIR}/Filters/${folder}/vtk.module")
  endforeach ()
  list(REMOVE_ITEM files ${large})
  set("${out}" ${large} ${files} PARENT_SCOPE)
endfunction ()

# The pool of targets with large sources: one job for each 3 GB of memory, at least two.
function (isthmus_large_source_pool)
  cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY) # MiB
  # Less in a container or another control group, of version 2 or 1.
  set(limits /sys/fs/cgroup/memory.max /sys/fs/cgroup/memory/memory.limit_in_bytes)
  if (EXISTS /proc/self/cgroup)
    file(STRINGS /proc/self/cgroup groups REGEX "^0::|:memory:")
    foreach (group IN LISTS groups)
      string(REGEX REPLACE "^[^:]*:[^:]*:" "" group "${group}")
      list(APPEND limits "/sys/fs/cgroup${group}/memory.max"
        "/sys/fs/cgroup/memory${group}/memory.limit_in_bytes")
    endforeach ()
  endif ()
  foreach (limit IN LISTS limits)
    if (EXISTS "${limit}")
      file(READ "${limit}" bytes)
      string(STRIP "${bytes}" bytes)
      if (bytes MATCHES "^[0-9]+$" AND bytes LESS 1000000000000000)
        math(EXPR mebibytes "${bytes} >> 20")
        if (mebibytes LESS memory)
          set(memory "${mebibytes}")
        endif ()
      endif ()
    endif ()
  endforeach ()
  math(EXPR depth "${memory} / 3000")
  if (depth LESS 2)
    set(depth 2)
  endif ()
  set_property(GLOBAL APPEND PROPERTY JOB_POOLS "isthmus_large=${depth}")
endfunction ()
isthmus_large_source_pool()

# isthmus_declared(OUT PREFIX FILES HEADING...): the modules whose names begin with PREFIX (VTK::,
# Isthmus::), without it, under these headings (DEPENDS, PRIVATE_DEPENDS, TEST_DEPENDS) of FILES.
function (isthmus_declared out prefix files)
  set(found)
  foreach (file IN LISTS files)
    set(heading)
    file(STRINGS "${file}" lines)
    foreach (line IN LISTS lines)
      if (line MATCHES "^[A-Z_]+$")
        set(heading "${line}")
      elseif (heading IN_LIST ARGN AND line MATCHES "^ +${prefix}(.+)$")
        list(APPEND found "${CMAKE_MATCH_1}")
      endif ()
    endforeach ()
  endforeach ()
  list(REMOVE_DUPLICATES found)
  list(SORT found)
  set("${out}" ${found} PARENT_SCOPE)
endfunction ()

# isthmus_vtk_components(OUT HEADING...): names of VTK's modules under these headings of all modules.
function (isthmus_vtk_components out)
  isthmus_module_files(files)
  isthmus_declared(found "VTK::" "${files}" ${ARGN})
  set("${out}" ${found} PARENT_SCOPE)
endfunction ()

set(ISTHMUS_SOURCE_DIR "${CMAKE_CURRENT_LIST_DIR}/..")
get_filename_component(ISTHMUS_SOURCE_DIR "${ISTHMUS_SOURCE_DIR}" ABSOLUTE)

# At this level, since several folders need the variables that it sets.
find_package(CGAL 5.5 REQUIRED)

function (isthmus_add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 module "" ""
    "CLASSES;HEADERS;SOURCES;CGAL;LARGE;VECTORISED")
  if (module_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "isthmus_add_module: unknown arguments ${module_UNPARSED_ARGUMENTS}")
  endif ()
  get_filename_component(folder "${CMAKE_CURRENT_SOURCE_DIR}" NAME)
  set(others "Mac|Windows")
  if (WIN32)
    set(others "Linux|Mac|Posix")
  elseif (APPLE)
    set(others "Linux|Windows")
  endif ()
  list(FILTER module_SOURCES EXCLUDE REGEX "(${others})$")
  list(TRANSFORM module_HEADERS APPEND ".h")
  foreach (kind IN ITEMS SOURCES CGAL LARGE VECTORISED)
    list(TRANSFORM module_${kind} APPEND ".cxx")
  endforeach ()

  vtk_module_add_module(${name}
    CLASSES ${module_CLASSES}
    SOURCES ${module_SOURCES} ${module_CGAL} ${module_LARGE} ${module_VECTORISED})
  set_property(GLOBAL APPEND PROPERTY ISTHMUS_CLASSES ${module_CLASSES}) # ResultDigests covers them
  vtk_module_compile_features(${name} PUBLIC cxx_std_17)

  # A separate folder with only this module's headers, so that "Imaging/X.h" is found only by
  # modules that declare this one.
  set(include_dir "${CMAKE_CURRENT_BINARY_DIR}/include")
  file(MAKE_DIRECTORY "${include_dir}")
  file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}" "${include_dir}/${folder}" SYMBOLIC)
  vtk_module_include(${name} PUBLIC "$<BUILD_INTERFACE:${include_dir}>")
  vtk_module_install_headers(FILES ${module_HEADERS} SUBDIR "${folder}")

  # Loops with square roots and comparisons are vectorised only if these need not set errno or raise
  # signals; results (including infinities and NaN) are the same.
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    set_source_files_properties(${module_VECTORISED} PROPERTIES
      COMPILE_OPTIONS "-fno-math-errno;-fno-trapping-math")
  endif ()

  # Not linked as CGAL::CGAL, whose compile options would slow down the loops of other sources.
  if (module_CGAL OR module_LARGE)
    vtk_module_include(${name} SYSTEM PRIVATE ${CGAL_INCLUDE_DIRS})
    vtk_module_link(${name} PRIVATE ${MPFR_LIBRARIES} ${GMP_LIBRARIES})
    vtk_module_definitions(${name} PRIVATE CGAL_NO_WARNINGS) # to stderr; Isthmus reports through VTK
    set(options "-frounding-math")
    # GCC finds these in code inlined from CGAL, other versions of it in other places, and is wrong.
    if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      list(APPEND options "-Wno-maybe-uninitialized" "-Wno-array-bounds" "-Wno-stringop-overflow")
    endif ()
    if (module_SOURCES OR module_VECTORISED)
      set_source_files_properties(${module_CGAL} PROPERTIES COMPILE_OPTIONS "${options}")
    else ()
      vtk_module_compile_options(${name} PRIVATE ${options})
    endif ()
  endif ()

  # Their time is spent in instantiating templates: -O2 is as fast at run time, and a compiler that
  # frees its memory more often needs a third less.
  if (module_LARGE)
    list(APPEND options "-O2")
    if (CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      list(APPEND options "--param=ggc-min-heapsize=600000" "--param=ggc-min-expand=30")
    endif ()
    set_source_files_properties(${module_LARGE} PROPERTIES COMPILE_OPTIONS "${options}")
    get_target_property(target ${name} ALIASED_TARGET)
    set_target_properties(${target} PROPERTIES JOB_POOL_COMPILE isthmus_large)
  endif ()

  # Compiled in groups, each of which parses VTK's headers and instantiates templates once: half of
  # the time. CMake leaves sources with options of their own out. -DCMAKE_UNITY_BUILD=OFF compiles
  # each source alone.
  get_target_property(target ${name} ALIASED_TARGET)
  if (NOT DEFINED CMAKE_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  endif ()

  vtk_module_link(${name} PRIVATE "$<BUILD_INTERFACE:isthmus_compiler>")

  # A module that calls undeclared modules must also fail to link. Not with sanitizers, whose symbols
  # are defined by the program.
  if (CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT ISTHMUS_SANITIZE AND NOT ISTHMUS_FUZZ)
    vtk_module_link_options(${name} PRIVATE "LINKER:--no-undefined")
  endif ()
endfunction ()
