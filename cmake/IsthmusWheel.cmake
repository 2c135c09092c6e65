# The build that pyproject.toml asks for: the package `isthmus` beside pip's `vtk`, in a wheel.

# The one Python is that of pip, whose vtk the package is built against.
find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)

# Elsewhere than on Linux, the build requirement vtk-sdk sets the prefix itself.
set(sdk "$ENV{ISTHMUS_VTK_SDK}")
if (NOT sdk)
  set(sdk "${CMAKE_BINARY_DIR}/vtk_sdk")
endif ()
string(FIND "${VTK_DIR}" "${sdk}/" ours)
if (CMAKE_SYSTEM_NAME STREQUAL "Linux" AND (NOT VTK_DIR OR ours EQUAL 0))
  message(STATUS "SDK for the vtk wheel in ${sdk}")
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_LIST_DIR}/wheel/linux_sdk.py" "${sdk}"
    OUTPUT_VARIABLE VTK_DIR
    OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)
  set(VTK_DIR "${VTK_DIR}" CACHE PATH "The directory containing a CMake configuration file for VTK." FORCE)
endif ()

# Libraries in C++ must be compiled as the vtk wheel is, which those of Debian are not; gemmi is one from 0.6 on.
if (CMAKE_SYSTEM_NAME STREQUAL "Linux")
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
