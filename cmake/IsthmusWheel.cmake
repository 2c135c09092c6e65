# The build that pyproject.toml asks for: the package `isthmus` beside pip's `vtk`, in a wheel.

# The one Python is that of pip, whose vtk the package is built against.
find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)

execute_process(
  COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_LIST_DIR}/wheel/check_sdk.py"
  OUTPUT_VARIABLE vtk
  OUTPUT_STRIP_TRAILING_WHITESPACE
  COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" vtk "${vtk}")
list(GET vtk 0 vtk_version)
list(GET vtk 1 ISTHMUS_VTK_LIBRARIES) # in the assembled SDK's targets
list(GET vtk 2 new_strings)
if (CMAKE_SYSTEM_NAME STREQUAL "Linux")
  add_compile_definitions("_GLIBCXX_USE_CXX11_ABI=${new_strings}")
endif ()

# The SDK is the one given, else that of the build requirement vtk-sdk, which sets the prefix itself (not on Linux), else
# one that is assembled here.
set(assembled "${CMAKE_BINARY_DIR}/vtk_sdk")
string(FIND "${VTK_DIR}" "${assembled}/" ours)
if (NOT VTK_DIR OR ours EQUAL 0)
  set(given "$ENV{ISTHMUS_VTK_SDK}")
  if (given)
    file(GLOB_RECURSE found "${given}/vtk-config.cmake")
    if (NOT found)
      message(FATAL_ERROR "ISTHMUS_VTK_SDK (${given}) holds no SDK of VTK: there is no vtk-config.cmake in it.")
    endif ()
    list(GET found 0 found)
    get_filename_component(found "${found}" DIRECTORY)
  elseif (CMAKE_SYSTEM_NAME STREQUAL "Linux")
    message(STATUS "SDK for vtk ${vtk_version} in ${assembled}")
    execute_process(
      COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_LIST_DIR}/wheel/linux_sdk.py" "${assembled}" "${vtk_version}"
      OUTPUT_VARIABLE found
      OUTPUT_STRIP_TRAILING_WHITESPACE
      COMMAND_ERROR_IS_FATAL ANY)
  endif ()
  if (found)
    set(VTK_DIR "${found}" CACHE PATH "The directory containing a CMake configuration file for VTK." FORCE)
  endif ()
endif ()

# isthmus_check_sdk(): stops where the options of the VTK that was found differ from those of the installed vtk.
function (isthmus_check_sdk)
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_SOURCE_DIR}/cmake/wheel/check_sdk.py" "${VTK_DIR}"
    RESULT_VARIABLE status
    ERROR_VARIABLE message)
  if (status)
    message(FATAL_ERROR "${message}")
  endif ()
endfunction ()
if (VTK_DIR)
  isthmus_check_sdk() # before find_package() fails for a lesser reason
endif ()

# Libraries in C++ must be compiled as the vtk wheel is, which those of Debian are not; gemmi is one from 0.6 on.
if (CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT new_strings)
  find_library(GEMMI_LIBRARY gemmi_cpp)
  if (GEMMI_LIBRARY)
    message(FATAL_ERROR "gemmi is a compiled library here (${GEMMI_LIBRARY}), with other strings than those of the vtk "
      "wheel: build the wheel where gemmi is headers only (0.5: Debian 12).")
  endif ()
endif ()

# Everything of the wheel lies in one folder, beside that of vtk's libraries.
set(CMAKE_INSTALL_LIBDIR isthmus)
if (APPLE)
  set(CMAKE_INSTALL_RPATH "@loader_path;@loader_path/../vtkmodules/.dylibs")
elseif (UNIX)
  set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/../vtkmodules")
  # Isthmus is found by its libraries' own names in tests, too.
  set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)
endif ()
