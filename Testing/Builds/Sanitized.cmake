include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

# Leaks of VTK's and Qt's own globals are not ours to judge; ours would show as errors elsewhere.
set(ENV{ASAN_OPTIONS} "detect_leaks=0")
set(folder "${WORK_DIR}/sanitized")
build_plain("${folder}" -DISTHMUS_TESTING=ON -DISTHMUS_SANITIZE=ON)
run("${CMAKE_CTEST_COMMAND}" --test-dir "${folder}" --output-on-failure)
