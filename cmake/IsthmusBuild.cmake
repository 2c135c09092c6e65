# The VTK module and its Python package, laid out in the build tree as they will be installed.

# A function, so that the CMAKE_BINARY_DIR it sets stays inside: vtk_module_build() adds the root
# as a subdirectory of CMAKE_BINARY_DIR, which must not be the build tree of the root itself.
function (isthmus_build_module)
  vtk_module_scan(
    MODULE_FILES "${CMAKE_CURRENT_SOURCE_DIR}/vtk.module"
    REQUEST_MODULES Isthmus::vtkIsthmus
    PROVIDES_MODULES modules
    REQUIRES_MODULES required
    HIDE_MODULES_FROM_CACHE ON)
  foreach (module IN LISTS required)
    if (NOT TARGET "${module}")
      message(FATAL_ERROR "VTK was found without its module ${module}, which Isthmus needs.")
    endif ()
  endforeach ()

  set(root_binary_dir "${CMAKE_BINARY_DIR}")
  set(CMAKE_BINARY_DIR "${root_binary_dir}/module")
  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${root_binary_dir}/${CMAKE_INSTALL_LIBDIR}")
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${root_binary_dir}/${CMAKE_INSTALL_BINDIR}")
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
  set_property(GLOBAL PROPERTY isthmus_modules "${modules}")
endfunction ()

# `import isthmus`: the wrapped classes and what __init__.py adds.
function (isthmus_build_python)
  get_property(modules GLOBAL PROPERTY isthmus_modules)
  vtk_module_python_default_destination(destination)
  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
  vtk_module_wrap_python(
    MODULES ${modules}
    TARGET Isthmus::IsthmusPython # TARGET X::Python would install a Python.h over CPython's.
    PYTHON_PACKAGE isthmus
    MODULE_DESTINATION "${destination}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    INSTALL_HEADERS OFF)
  set(package "${CMAKE_CURRENT_SOURCE_DIR}/cmake/isthmus_init.py")
  configure_file("${package}" "${CMAKE_BINARY_DIR}/${destination}/isthmus/__init__.py" COPYONLY)
  install(FILES "${package}" DESTINATION "${destination}/isthmus" RENAME __init__.py)
  # The same files travel inside the plugin, for windows without this package.
  foreach (part IN ITEMS pipelines charges look pockets trajectories)
    set(source "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/isthmus_${part}.py")
    configure_file("${source}" "${CMAKE_BINARY_DIR}/${destination}/isthmus/${part}.py" COPYONLY)
    install(FILES "${source}" DESTINATION "${destination}/isthmus" RENAME ${part}.py)
  endforeach ()
  set_property(GLOBAL PROPERTY isthmus_python_destination "${destination}")
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
endfunction ()
