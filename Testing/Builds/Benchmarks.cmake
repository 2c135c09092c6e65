# -DISTHMUS_BENCHMARKS=ON: every benchmark compiles and links, and lists its rows; none is measured. They are linked to
# the library of the main build, and compiled without optimisation, which takes half of the time.
# Peers that are not installed are left out, as in Testing/Benchmarks/CMakeLists.txt.
include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(folder "${WORK_DIR}/benchmarks")
file(REMOVE_RECURSE "${folder}")
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/benchmarks" -B "${folder}" -G Ninja
  -DISTHMUS_BENCHMARKS=ON -DISTHMUS_WERROR=ON -DCMAKE_BUILD_TYPE=Release
  "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG" "-DCMAKE_CXX_COMPILER_LAUNCHER=${CXX_LAUNCHER}"
  "-DSOURCES=${SOURCE_DIR}" "-DMAIN_BINARY_DIR=${MAIN_BINARY_DIR}" "-DParaView_DIR=${ParaView_DIR}"
  "-DOpenVolumeMesh_DIR=${OpenVolumeMesh_DIR}"
  "-DISTHMUS_DEFAULT_DATA_DIR=${DATA_DIR}")
run("${CMAKE_COMMAND}" --build "${folder}" -- -k 0)

file(GLOB sources "${SOURCE_DIR}/Testing/Benchmarks/Bench*.cxx")
foreach (source IN LISTS sources)
  get_filename_component(name "${source}" NAME_WE)
  execute_process(COMMAND "${folder}/Testing/Benchmarks/${name}" --benchmark_list_tests
    RESULT_VARIABLE result OUTPUT_VARIABLE rows ERROR_VARIABLE said)
  string(REGEX MATCHALL "[^\n]+" rows "${rows}")
  list(LENGTH rows count)
  message(STATUS "${name}: ${count}")
  if (NOT result EQUAL 0 OR count EQUAL 0)
    message(SEND_ERROR "${name} lists no benchmark (${result}): ${said}")
  endif ()
endforeach ()
