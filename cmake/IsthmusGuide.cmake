# `cmake --build build --target guide`: the user guide with the C++ reference, in <build>/guide/html. It needs
# no compiled code, and the programs that cmake/setup.sh lists as guide_packages; it is not part of `all`.

find_package(Python3 COMPONENTS Interpreter QUIET)
if (Python3_Interpreter_FOUND)
  add_custom_target(guide
    COMMAND "${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_SOURCE_DIR}/Examples/guide/build_guide.py"
      "${CMAKE_BINARY_DIR}/guide" --version "${PROJECT_VERSION}"
    COMMENT "Building the guide"
    USES_TERMINAL
    VERBATIM)
endif ()
