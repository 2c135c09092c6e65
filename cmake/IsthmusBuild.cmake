# The VTK modules and their Python package, laid out in the build tree as they will be installed.

# All modules, and `Isthmus::vtkIsthmus`, the one target that links them all.
function (isthmus_build_modules)
  isthmus_module_files(module_files)
  vtk_module_scan(
    MODULE_FILES ${module_files}
    WANT_BY_DEFAULT ON
    PROVIDES_MODULES modules
    REQUIRES_MODULES required
    HIDE_MODULES_FROM_CACHE ON)
  foreach (module IN LISTS required)
    if (NOT TARGET "${module}")
      message(FATAL_ERROR "VTK was found without its module ${module}, which Isthmus needs.")
    endif ()
  endforeach ()

  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
  set(CMAKE_WINDOWS_EXPORT_ALL_SYMBOLS ON)
  vtk_module_build(
    MODULES ${modules}
    PACKAGE Isthmus
    INSTALL_EXPORT Isthmus
    TEST_DIRECTORY_NAME NONE # Testing is ours, added by the root.
    INSTALL_HEADERS ON
    ENABLE_WRAPPING "${ISTHMUS_PARAVIEW}"
    HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/isthmus"
    CMAKE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/Isthmus"
    LICENSE_DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/Isthmus"
    HIERARCHY_DESTINATION "${CMAKE_INSTALL_LIBDIR}/vtk/hierarchy/Isthmus")

  add_library(vtkIsthmus INTERFACE)
  add_library(Isthmus::vtkIsthmus ALIAS vtkIsthmus)
  target_link_libraries(vtkIsthmus INTERFACE ${modules})
  install(TARGETS vtkIsthmus EXPORT Isthmus)
  set_property(GLOBAL PROPERTY isthmus_modules "${modules}")
endfunction ()

# Generated wrappers of one module's classes read the same headers and never change alone: compiled as
# one source, the headers are parsed once. They convert arguments: optimising them further would cost
# a third of their compile time and speed up nothing.
function (isthmus_compile_together target)
  if (TARGET "${target}")
    set_target_properties("${target}" PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    target_compile_options("${target}" PRIVATE
      "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:-O1>")
  endif ()
endfunction ()

# `import isthmus`: the wrapped classes of all modules and what __init__.py adds.
function (isthmus_build_python)
  get_property(modules GLOBAL PROPERTY isthmus_modules)
  vtk_module_python_default_destination(destination)
  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
  vtk_module_wrap_python(
    MODULES ${modules}
    WRAPPED_MODULES wrapped
    TARGET Isthmus::IsthmusPython # TARGET X::Python would install a Python.h over CPython's.
    PYTHON_PACKAGE isthmus
    MODULE_DESTINATION "${destination}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    INSTALL_HEADERS OFF)

  set(ISTHMUS_PYTHON_IMPORTS)
  foreach (module IN LISTS wrapped)
    string(REPLACE "Isthmus::" "vtkIsthmus" library "${module}")
    isthmus_compile_together("${library}Python")
    string(APPEND ISTHMUS_PYTHON_IMPORTS "from .${library} import *  # noqa: F401,F403\n")
  endforeach ()
  configure_file("${CMAKE_CURRENT_SOURCE_DIR}/cmake/isthmus_init.py.in"
    "${CMAKE_BINARY_DIR}/${destination}/isthmus/__init__.py" @ONLY)
  install(FILES "${CMAKE_BINARY_DIR}/${destination}/isthmus/__init__.py"
    DESTINATION "${destination}/isthmus")
  set(old_name "${CMAKE_CURRENT_SOURCE_DIR}/cmake/vtkIsthmus.py")
  configure_file("${old_name}" "${CMAKE_BINARY_DIR}/${destination}/isthmus/vtkIsthmus.py" COPYONLY)
  install(FILES "${old_name}" DESTINATION "${destination}/isthmus")
  # The same files travel inside the plugin, for windows without this package.
  foreach (part IN ITEMS pipelines look messages pockets trajectories)
    set(source "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/isthmus_${part}.py")
    configure_file("${source}" "${CMAKE_BINARY_DIR}/${destination}/isthmus/${part}.py" COPYONLY)
    install(FILES "${source}" DESTINATION "${destination}/isthmus" RENAME ${part}.py)
  endforeach ()
  set_property(GLOBAL PROPERTY isthmus_python_destination "${destination}")
  set(ISTHMUS_PYTHON_DESTINATION "${destination}" CACHE INTERNAL "Where the Python package is (setup.sh)")
endfunction ()

# The plugin: one library with the panels of Plugin/*.xml.
function (isthmus_build_plugin)
  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
  paraview_plugin_scan(
    PLUGIN_FILES "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin"
    PROVIDES_PLUGINS plugins
    ENABLE_BY_DEFAULT ON
    HIDE_PLUGINS_FROM_CACHE ON)
  paraview_plugin_build(
    PLUGINS ${plugins}
    LIBRARY_SUBDIRECTORY "isthmus/plugins"
    INSTALL_HEADERS OFF
    PLUGINS_FILE_NAME "isthmus.plugins.xml")
  get_property(modules GLOBAL PROPERTY isthmus_modules)
  foreach (module IN LISTS modules)
    string(REPLACE "Isthmus::" "vtkIsthmus" library "${module}")
    isthmus_compile_together("${library}CS")
  endforeach ()
endfunction ()
