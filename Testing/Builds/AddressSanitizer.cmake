# Included by Sanitized.cmake: address, undefined behaviour, leaks.

# VTK's own globals are reachable, so they are no leaks and nothing has to be suppressed. A fuzz
# input may well ask for too much memory.
set(ENV{ASAN_OPTIONS} "detect_leaks=1:allocator_may_return_null=1")
set(folder "${WORK_DIR}/sanitized")
build_sanitized("${folder}" "-DISTHMUS_UNIT_SHARE=${share}" -DISTHMUS_FUZZ=ON -DISTHMUS_SANITIZE=address,undefined)
# A program of somebody else's, which needs nothing but find_package(VTK) and this.
set(prefix "${WORK_DIR}/sanitized-installed")
file(REMOVE_RECURSE "${prefix}")
run("${CMAKE_COMMAND}" --install "${folder}" --prefix "${prefix}")
run_consumer("${prefix}" "${WORK_DIR}/sanitized-consumer" ${compiler}
  -DCMAKE_CXX_FLAGS=-fsanitize=address,undefined)
run("${CMAKE_CTEST_COMMAND}" --test-dir "${folder}" --output-on-failure --parallel 2 -L "unit|integration"
  --exclude-regex "${long_tests}")

file(GLOB targets "${folder}/Testing/Fuzz/Fuzz*")
if (NOT targets)
  message(FATAL_ERROR "no fuzz target was built in ${folder}/Testing/Fuzz")
endif ()
set(corpus "${WORK_DIR}/fuzz-corpus")
file(REMOVE_RECURSE "${corpus}")
file(ARCHIVE_EXTRACT INPUT "${SOURCE_DIR}/Testing/Data/fuzz-corpus.tar.xz" DESTINATION "${corpus}")
# Two at a time: the commands of one execute_process run side by side.
set(fuzz_options -max_total_time=10 -rss_limit_mb=2048 -timeout=10 -print_final_stats=1)
while (targets)
  list(POP_FRONT targets first second)
  set(commands "")
  foreach (target IN ITEMS ${first} ${second})
    get_filename_component(name "${target}" NAME)
    file(MAKE_DIRECTORY "${corpus}/${name}") # a new target may have none yet
    list(APPEND commands COMMAND "${target}" ${fuzz_options} "${corpus}/${name}")
  endforeach ()
  message(STATUS "${first} ${second}")
  execute_process(${commands} COMMAND_ERROR_IS_FATAL ANY)
endwhile ()
