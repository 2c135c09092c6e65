# `cmake --build build --target guide`: the user guide with the C++ reference, in <build>/guide/html. It needs
# no compiled code, and the programs that cmake/setup.sh lists as guide_packages; it is not part of `all`.
# `--target scenes`, before it: the scenes of its gallery, by the plugin and from the shared data.

find_package(Python3 COMPONENTS Interpreter QUIET)
if (Python3_Interpreter_FOUND)
  add_custom_target(guide
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/Documentation/build_guide.py"
      "${CMAKE_BINARY_DIR}/guide" --version "${PROJECT_VERSION}"
    COMMENT "Building the guide"
    USES_TERMINAL
    VERBATIM)
  if (ISTHMUS_PARAVIEW)
    add_custom_target(scenes
      COMMAND "${CMAKE_COMMAND}" -E env "ISTHMUS_BUILD_DIR=${CMAKE_BINARY_DIR}" bash -c
        "source cmake/setup.sh && use_build_tree && with_display pvpython Examples/scenes.py '${CMAKE_BINARY_DIR}/guide/scenes'"
      DEPENDS Isthmus
      WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
      COMMENT "Making the scenes of the guide's gallery"
      USES_TERMINAL
      VERBATIM)
  endif ()
endif ()
