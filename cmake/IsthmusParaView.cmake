# What differs between the CMake packages of ParaView, and of the VTK inside it.
#
# - Debian's paraview-dev 5.13.2 to 6.1.1 name Python modules without their ABI suffix (vtkCommonCore.so
#   for vtkCommonCore.cpython-313-x86_64-linux-gnu.so), and find_package stops for missing files.
#   isthmus_correct_package defines these targets beforehand, with the names of the files that are
#   there; the package then takes them as already defined. 5.11 and packages without the defect:
#   nothing is done.
#
# Also installed beside IsthmusConfig.cmake, whose users search the same VTK.

# isthmus_package_folder(OUT NAME VERSION): the folder of the CMake package that find_package would
# read, without reading it; empty where there is none of this version or newer.
function (isthmus_package_folder out name version)
  set(given "${${name}_DIR}")
  find_package("${name}" 65535 QUIET CONFIG HINTS ${ARGN}) # considers all, accepts none
  if (given)
    set("${name}_DIR" "${given}" CACHE PATH "The directory containing a CMake configuration file for ${name}." FORCE)
  else ()
    unset("${name}_DIR" CACHE)
  endif ()
  set("${out}" "" PARENT_SCOPE)
  foreach (config found IN ZIP_LISTS "${name}_CONSIDERED_CONFIGS" "${name}_CONSIDERED_VERSIONS")
    if (found VERSION_GREATER_EQUAL version)
      get_filename_component(folder "${config}" DIRECTORY)
      set("${out}" "${folder}" PARENT_SCOPE)
      return ()
    endif ()
  endforeach ()
endfunction ()

# isthmus_correct_package(NAME VERSION [HINT...]): call it before find_package(NAME VERSION HINTS HINT...).
function (isthmus_correct_package name version)
  isthmus_package_folder(folder "${name}" "${version}" ${ARGN})
  if (NOT folder)
    return ()
  endif ()
  # Those of VTK first: those of ParaView refer to them.
  file(GLOB exports "${folder}/vtk/*Python*-targets.cmake")
  file(GLOB own "${folder}/*Python*-targets.cmake")
  foreach (export IN LISTS exports own)
    isthmus_correct_export("${export}")
  endforeach ()
endfunction ()

# isthmus_correct_export(FILE): includes FILE, an export of Python modules, with the names of the
# modules that are there; does nothing where its own are right.
function (isthmus_correct_export file)
  string(REGEX REPLACE "/lib/.*$" "" prefix "${file}")
  string(REGEX REPLACE "[.]cmake$" "" stem "${file}")
  file(GLOB parts "${stem}-*.cmake")
  get_filename_component(folder "${file}" NAME_WE)
  set(folder "${CMAKE_BINARY_DIR}/corrected_packages/${folder}")
  set(corrected FALSE)
  foreach (part IN LISTS parts)
    file(READ "${part}" text)
    string(REGEX MATCHALL "[$]{_IMPORT_PREFIX}/[^\"]*[.]so" modules "${text}")
    list(REMOVE_DUPLICATES modules)
    foreach (module IN LISTS modules)
      string(REPLACE "\${_IMPORT_PREFIX}" "${prefix}" path "${module}")
      string(REGEX REPLACE "[.]so$" "" module_stem "${path}")
      file(GLOB present "${module_stem}.cpython-*.so" "${module_stem}.abi3.so")
      if (NOT EXISTS "${path}" AND present MATCHES "^[^;]+$")
        string(REPLACE "\"${module}\"" "\"${present}\"" text "${text}")
        set(corrected TRUE)
      endif ()
    endforeach ()
    get_filename_component(name "${part}" NAME)
    file(WRITE "${folder}/${name}" "${text}")
  endforeach ()
  if (NOT corrected)
    file(REMOVE_RECURSE "${folder}")
    return ()
  endif ()
  message(STATUS "Corrected names of Python modules in ${file}")
  # The prefix is that of the original.
  file(READ "${file}" text)
  string(REPLACE "(_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\" PATH)" "(_IMPORT_PREFIX \"${file}\" PATH)"
    text "${text}")
  get_filename_component(name "${file}" NAME)
  file(WRITE "${folder}/${name}" "${text}")
  include("${folder}/${name}")
endfunction ()
