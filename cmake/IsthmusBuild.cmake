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
  set(wrapped OFF)
  if (ISTHMUS_PARAVIEW OR ISTHMUS_WHEEL)
    set(wrapped ON)
  endif ()
  vtk_module_build(
    MODULES ${modules}
    PACKAGE Isthmus
    INSTALL_EXPORT Isthmus
    TEST_DIRECTORY_NAME NONE # Testing is ours, added by the root.
    INSTALL_HEADERS ON
    ENABLE_WRAPPING "${wrapped}"
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
  # As vtk_module_python_default_destination would say, but Debian's of VTK 9.6 names dist-packages.
  if (NOT DEFINED Python3_VERSION_MINOR)
    find_package(Python3 REQUIRED COMPONENTS Development.Module)
  endif ()
  set(destination
    "${CMAKE_INSTALL_LIBDIR}/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/site-packages")
  set(wheel_arguments)
  if (ISTHMUS_WHEEL)
    set(destination ".")
    set(wheel_arguments SOABI "${Python3_SOABI}")
  endif ()
  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
  vtk_module_wrap_python(
    MODULES ${modules}
    WRAPPED_MODULES wrapped
    TARGET Isthmus::IsthmusPython # TARGET X::Python would install a Python.h over CPython's.
    PYTHON_PACKAGE isthmus
    MODULE_DESTINATION "${destination}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    INSTALL_HEADERS OFF
    ${wheel_arguments})

  foreach (module IN LISTS wrapped)
    string(REPLACE "Isthmus::" "vtkIsthmus" library "${module}")
    isthmus_compile_together("${library}Python")
  endforeach ()
  isthmus_python_sources("${CMAKE_BINARY_DIR}/${destination}/isthmus" "${destination}/isthmus")
  if (ISTHMUS_WHEEL)
    isthmus_python_stubs("${wrapped}" "${CMAKE_BINARY_DIR}/${destination}" "${destination}/isthmus")
  endif ()
  set_property(GLOBAL PROPERTY isthmus_python_destination "${destination}")
  set(ISTHMUS_PYTHON_DESTINATION "${destination}" CACHE INTERNAL "Where the Python package is (setup.sh)")
endfunction ()

# isthmus_python_stubs(WRAPPED FOLDER DESTINATION): stubs of the classes, by VTK's own script, which loads them.
function (isthmus_python_stubs wrapped folder destination)
  string(REPLACE "Isthmus::" "vtkIsthmus" libraries "${wrapped}")
  set(stubs "${libraries}")
  list(TRANSFORM stubs PREPEND "${folder}/isthmus/")
  list(TRANSFORM stubs APPEND ".pyi")
  set(targets "${libraries}")
  list(TRANSFORM targets APPEND "Python")
  add_custom_command(
    OUTPUT ${stubs}
    COMMAND "${Python3_EXECUTABLE}" -m vtkmodules.generate_pyi -p isthmus -o "${folder}/isthmus" ${libraries}
    WORKING_DIRECTORY "${folder}"
    DEPENDS ${targets} isthmus_python_description
    COMMENT "Writing stubs of the classes"
    VERBATIM)
  add_custom_target(isthmus_python_stubs ALL DEPENDS ${stubs})
  install(FILES ${stubs} DESTINATION "${destination}" COMPONENT python)
endfunction ()

# Modules of the Python package that serve ParaView; the plugin has a copy of them (Plugin/CMakeLists.txt).
set(ISTHMUS_PARAVIEW_PYTHON cameras colours comparisons diagram_views entries figures levels look loop_views messages
  molecule_views pipelines pocket_views selections steps track_views trajectories)

# isthmus_panels(OUT): the panels of Plugin/*.xml in the build tree, with the formats of molecules.
function (isthmus_panels out)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(script "${CMAKE_SOURCE_DIR}/Wrapping/Python/panel_files.py")
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/Plugin/*.xml")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
    "${script}" "${CMAKE_SOURCE_DIR}/Readers/Molecules/MoleculeFormats.h" ${sources})
  execute_process(
    COMMAND "${Python3_EXECUTABLE}" -B "${script}" "${CMAKE_SOURCE_DIR}" "${CMAKE_BINARY_DIR}/panels"
    COMMAND_ERROR_IS_FATAL ANY)
  list(TRANSFORM sources REPLACE "^.*/" "${CMAKE_BINARY_DIR}/panels/")
  set("${out}" ${sources} PARENT_SCOPE)
endfunction ()

# isthmus_python_sources(FOLDER DESTINATION): what is not compiled, in the build tree and installed. Functions are
# made of the panels, whose description is written at each build.
function (isthmus_python_sources folder destination)
  set(from "${CMAKE_CURRENT_SOURCE_DIR}/Wrapping/Python")
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  file(GLOB panels CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/*.xml")
  file(GLOB lists CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/Filters/*/CMakeLists.txt"
    "${CMAKE_CURRENT_SOURCE_DIR}/Readers/*/CMakeLists.txt")
  file(GLOB tables CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/[FR]*/*/vtk*.cxx"
    "${CMAKE_CURRENT_SOURCE_DIR}/Filters/*/*Arrays.h")
  set(vtk)
  if (ISTHMUS_WHEEL)
    string(REGEX MATCH "^[0-9]+\\.[0-9]+" vtk "${vtk_version}")
  endif ()
  add_custom_command(
    OUTPUT "${folder}/filters.json" "${folder}/__init__.py" "${folder}/__init__.pyi"
    COMMAND "${Python3_EXECUTABLE}" -B "${from}/describe.py"
      "${CMAKE_CURRENT_SOURCE_DIR}" "${folder}" "${PROJECT_VERSION}" ${vtk}
    DEPENDS "${from}/describe.py" "${from}/output_arrays.py" "${from}/panel_files.py"
      "${CMAKE_CURRENT_SOURCE_DIR}/Readers/Molecules/MoleculeFormats.h" "${from}/isthmus/__init__.py.in"
      "${from}/isthmus/data_pipelines.py" "${from}/function_examples.txt" ${panels} ${lists} ${tables}
    COMMENT "Describing the filters for Python"
    VERBATIM)
  add_custom_target(isthmus_python_description ALL
    DEPENDS "${folder}/filters.json" "${folder}/__init__.py" "${folder}/__init__.pyi")
  get_property(modules GLOBAL PROPERTY isthmus_modules)
  foreach (module IN LISTS modules)
    string(REPLACE "Isthmus::" "vtkIsthmus" library "${module}")
    if (TARGET "${library}Python")
      add_dependencies("${library}Python" isthmus_python_description) # a class comes with the package
    endif ()
  endforeach ()
  install(FILES "${folder}/filters.json" "${folder}/__init__.py" "${folder}/__init__.pyi"
    DESTINATION "${destination}" COMPONENT python)

  set(sources "${from}/isthmus/py.typed")
  foreach (part IN ITEMS __main__ accessor command data_pipelines functions incidence notebooks other_libraries
      samples
      ${ISTHMUS_PARAVIEW_PYTHON})
    list(APPEND sources "${from}/isthmus/${part}.py")
  endforeach ()
  foreach (source IN LISTS sources)
    get_filename_component(name "${source}" NAME)
    configure_file("${source}" "${folder}/${name}" COPYONLY)
    install(FILES "${source}" DESTINATION "${destination}" COMPONENT python)
  endforeach ()
endfunction ()

# The plugin: one library with the panels of Plugin/*.xml.
function (isthmus_build_plugin)
  set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
  set(ISTHMUS_PLUGIN_FOLDER "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/isthmus/plugins")
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
