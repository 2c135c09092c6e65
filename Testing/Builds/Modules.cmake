# Module isolation. In a tree that is configured and not built: what a build of each module alone would
# compile is in it and in the modules that it declares; a source that includes a header of any other
# module does not compile. Compiled are a few lines only.
include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(folder "${WORK_DIR}/modules")
file(REMOVE_RECURSE "${folder}")
run("${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${folder}" -G Ninja -DISTHMUS_PARAVIEW=OFF
  -DCMAKE_UNITY_BUILD=OFF
  "-DVTK_DIR=${VTK_DIR}" "-DPython3_EXECUTABLE=${Python3_EXECUTABLE}")
run("${Python3_EXECUTABLE}" -B "${CMAKE_CURRENT_LIST_DIR}/check_isolation.py" "${SOURCE_DIR}" "${folder}")

# Inside VTK's source tree: one clear message.
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/inside_vtk"
    -B "${WORK_DIR}/inside-vtk" -G Ninja "-DSOURCES=${SOURCE_DIR}" "-DVTK_DIR=${VTK_DIR}"
  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
string(REGEX REPLACE "[ \n]+" " " said "${said}")
if (result EQUAL 0 OR NOT said MATCHES "Isthmus is built against VTK, not inside its source tree")
  message(FATAL_ERROR "a build inside VTK does not end with its message, but: ${said}")
endif ()
