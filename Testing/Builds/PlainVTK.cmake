include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(folder "${WORK_DIR}/plain")
build_plain("${folder}" -DISTHMUS_TESTING=ON)
run("${CMAKE_CTEST_COMMAND}" --test-dir "${folder}" --output-on-failure)

set(prefix "${WORK_DIR}/plain-installed")
file(REMOVE_RECURSE "${prefix}")
run("${CMAKE_COMMAND}" --install "${folder}" --prefix "${prefix}")
run_consumer("${prefix}" "${WORK_DIR}/plain-consumer")
