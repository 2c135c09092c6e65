include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

# Leaks of VTK's own globals are not ours to judge, and a fuzz input may well ask for too much memory.
set(ENV{ASAN_OPTIONS} "detect_leaks=0:allocator_may_return_null=1")
set(folder "${WORK_DIR}/sanitized")
# Of the unit tests' programs a third, another at each landing (as in Unit/Support/LongTests.h),
# without their own long cases; all of them with ISTHMUS_LONG_TESTS=1.
set(share 0)
if (NOT "$ENV{ISTHMUS_LONG_TESTS}" STREQUAL "1")
  set(turn 0)
  if ("$ENV{ISTHMUS_TURN}" MATCHES "^[0-9]+$")
    set(turn "$ENV{ISTHMUS_TURN}")
  endif ()
  math(EXPR share "${turn} % 3 + 1")
endif ()
unset(ENV{ISTHMUS_TURN})
# GCC's builds judge the warnings; clang has others.
set(compiler -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE=-O1)
build_plain("${folder}" ${compiler} "-DISTHMUS_UNIT_SHARE=${share}"
  -DISTHMUS_WERROR=OFF -DISTHMUS_TESTING=ON -DISTHMUS_FUZZ=ON -DISTHMUS_SANITIZE=address,undefined)
# A program of somebody else's, which needs nothing but find_package(VTK) and this.
set(prefix "${WORK_DIR}/sanitized-installed")
file(REMOVE_RECURSE "${prefix}")
run("${CMAKE_COMMAND}" --install "${folder}" --prefix "${prefix}")
run_consumer("${prefix}" "${WORK_DIR}/sanitized-consumer" ${compiler}
  -DCMAKE_CXX_FLAGS=-fsanitize=address,undefined)

# Left out: tests of seconds that become minutes here, of code that shorter ones reach as well.
set(long_tests "SuperStepsReachTheEnd|TimeOrderIsTwo|FourierModesDecay|IsosurfacesOfNoise"
  "|EverySharedSurfaceIsFilled|HasItsLoops/(129110|65004)|StrutsOfABuckyball|Runs/Stability"
  "|ErrorFallsWithRefinement|TheLongestSuperStep|MeanIsKept|PlateauOnIrregularMeshes|TestGridMap"
  "|SphereOf40Charges|IonsOfThreeRadii|SurfacePushToo|LayerPushToo|AreTheSlopeOfTheEnergy"
  "|StretchOfDNA|NarrowCavity|HasItsLoops/1514499|EqualsGudhiOn|DamagedSurfacesAreFilled"
  "|ChokingLoopsOfNeedlesEnd|TestPoissonBoltzmann.All"
  "|ProbeBetweenThreeBalls|SpheresThatCross|SteadyLysozyme|LysozymeByTime|AnglesStayWithinTheBounds"
  "|GradingKeepsTheSurface|SurfaceFlow.ThreadsLeaveNoTrace|CoarseToFineEnds|ThesisFlow.ComesToRest"
  "|SharedMaps.EqualGudhi|TurnsMirrorsAndShifts|ClosedWindows|ManufacturedInterface|IonsHaveBornsEnergy"
  "|IonsInTheSmoothMode"
  "|AgreesWithItself/(129110|72214|65004|1514499|emd_5043)|SurfaceMending.DamagedSurfaces"
  "|LysozymeStarts|EarlyLysozyme|IsAsNearToTheUniformOne|NoiseStaysManifoldWithItsHandles"
  "|NoTrianglesCrossWhere|SharpEdgesOfMachineParts|PolyhedraBecome|ManyKindsOfDamage"
  "|LimitsOfTimeAndMemory|ResultDigests|SquareOfTheSpacing|EdgesOfSampledSolids"
  "|AreTheSame/(elk|skull|cup)|OfAWallOfBlobs"
  "|CutsTheHandlesBelow|OneCutEndsAHandle|FastMarchingComesToTheDistance")
string(CONCAT long_tests ${long_tests})
run("${CMAKE_CTEST_COMMAND}" --test-dir "${folder}" --output-on-failure --parallel 2
  --exclude-regex "${long_tests}")

file(GLOB targets "${folder}/Testing/Fuzz/Fuzz*")
if (NOT targets)
  message(FATAL_ERROR "no fuzz target was built in ${folder}/Testing/Fuzz")
endif ()
# Two at a time: the commands of one execute_process run side by side.
set(fuzz_options -max_total_time=20 -rss_limit_mb=2048 -timeout=10 -print_final_stats=1)
while (targets)
  list(POP_FRONT targets first second)
  set(commands COMMAND "${first}" ${fuzz_options})
  if (second)
    list(APPEND commands COMMAND "${second}" ${fuzz_options})
  endif ()
  message(STATUS "${first} ${second}")
  execute_process(${commands} COMMAND_ERROR_IS_FATAL ANY)
endwhile ()
