# Included by Sanitized.cmake: data races, with more threads than processors. VTK is not instrumented,
# but its threads are started and locked by calls that the sanitizer sees, and ParallelFor tells when a
# loop has ended: nothing has to be suppressed.
set(ENV{VTK_SMP_BACKEND_IN_USE} STDThread)
set(ENV{VTK_SMP_MAX_THREADS} 4)
set(folder "${WORK_DIR}/sanitized-threads")
# Most parallel code goes through ParallelFor. These have threads, locks, atomics or shared arrays of their own,
# or write neighbouring rows; with ISTHMUS_LONG_TESTS=1 all programs are built.
set(only "")
if (NOT whole)
  set(only TestParallelFor TestGradientPaths TestSimplexOrder TestStarMatching TestStarDefects
    TestSurfaceToGrid TestDiffusionRows TestCompactCombinatorialMap TestCubicalPersistence
    TestParallelDrawing)
  list(JOIN only " " only)
endif ()
build_sanitized("${folder}" -DISTHMUS_UNIT_SHARE=0 "-DISTHMUS_UNIT_ONLY=${only}"
  -DISTHMUS_SANITIZE=thread)
run("${CMAKE_CTEST_COMMAND}" --test-dir "${folder}" --output-on-failure --parallel 2 -L "unit|integration"
  --exclude-regex "${long_tests}|HeadersWithHugeCountsAllocateNothing") # of the process' peak memory
unset(ENV{VTK_SMP_BACKEND_IN_USE})
unset(ENV{VTK_SMP_MAX_THREADS})
