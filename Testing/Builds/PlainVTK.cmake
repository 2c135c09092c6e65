include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(folder "${WORK_DIR}/plain")
build_plain("${folder}") # its unit tests are run by the sanitized build, which is plain as well

set(prefix "${WORK_DIR}/plain-installed")
file(REMOVE_RECURSE "${prefix}")
run("${CMAKE_COMMAND}" --install "${folder}" --prefix "${prefix}")
run_consumer("${prefix}" "${WORK_DIR}/plain-consumer")
