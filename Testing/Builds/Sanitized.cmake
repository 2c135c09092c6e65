# The plain module by clang under sanitizers, with leaks, all of it in turns (as in
# Unit/Core/LongTests.h), or whole with ISTHMUS_LONG_TESTS=1:
#   two turns of three   address and undefined behaviour: the consumer, a third of the unit tests'
#                        programs without their long cases, ten seconds of each fuzz target
#   the third            threads: the unit tests of what runs on threads, on four of them
include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(share 0)
set(sanitizers AddressSanitizer ThreadSanitizer)
set(whole FALSE)
if ("$ENV{ISTHMUS_LONG_TESTS}" STREQUAL "1")
  set(whole TRUE)
else ()
  set(turn 0)
  if ("$ENV{ISTHMUS_TURN}" MATCHES "^[0-9]+$")
    set(turn "$ENV{ISTHMUS_TURN}")
  endif ()
  math(EXPR share "${turn} % 3 + 1")
  math(EXPR third "${turn} / 3 % 3")
  if (third EQUAL 2)
    set(sanitizers ThreadSanitizer)
  else ()
    set(sanitizers AddressSanitizer)
  endif ()
endif ()
unset(ENV{ISTHMUS_TURN})
unset(ENV{ISTHMUS_LONG_TESTS}) # whole: all tests, not their long cases

# Left out: tests of seconds that become minutes here, of code that shorter ones reach as well, and
# one of the process' peak memory, to which sanitizers add.
set(long_tests "SuperStepsReachTheEnd|TimeOrderIsTwo|FourierModesDecay|IsosurfacesOfNoise"
  "|EverySharedSurfaceIsFilled|HasItsLoops/(129110|65004)|StrutsOfABuckyball|Runs/Stability"
  "|ErrorFallsWithRefinement|TheLongestSuperStep|MeanIsKept|PlateauOnIrregularMeshes|TestGridMap"
  "|SphereOf40Charges|IonsOfThreeRadii|SurfacePushToo|LayerPushToo|AreTheSlopeOfTheEnergy"
  "|StretchOfDNA|NarrowCavity|HasItsLoops/1514499|EqualsGudhiOn|DamagedSurfacesAreFilled"
  "|ChokingLoopsOfNeedlesEnd|TestPoissonBoltzmann.All"
  "|ProbeBetweenThreeBalls|SpheresThatCross|SteadyLysozyme|LysozymeByTime|AnglesStayWithinTheBounds"
  "|GradingKeepsTheSurface|SurfaceFlow.DoesNotDependOnThreads|CoarseToFineEnds|ThesisFlow.ComesToRest"
  "|SharedMaps.EqualGudhi|TurnsMirrorsAndShifts|ClosedWindows|ManufacturedInterface|IonsHaveBornsEnergy"
  "|IonsInTheSmoothMode"
  "|AgreesWithItself/(129110|72214|65004|1514499|emd_5043|bumpy|botijo|elk|cup|3holes)"
  "|RepairReport.DamagedSurfaces"
  "|LysozymeStarts|EarlyLysozyme|IsAsNearToTheUniformOne|NoiseStaysManifoldWithItsHandles"
  "|NoTrianglesCrossWhere|SharpEdgesOfMachineParts|PolyhedraBecome|ManyKindsOfDamage"
  "|LimitsOfTimeAndMemory|ResultDigests|SquareOfTheSpacing|EdgesOfSampledSolids"
  "|AreTheSame/(elk|skull|cup)|OfAWallOfBlobs"
  "|CutsTheHandlesBelow|OneCutEndsAHandle|FastMarchingComesToTheDistance"
  "|BytesAreWithinAFactorOfTwo|StagesSharingAPass|DiffusionSteps.ResultsDoNotDependOnThreads"
  "|SolvationPolicies")
string(CONCAT long_tests ${long_tests})

# build_sanitized(FOLDER OPTION...): GCC's builds judge the warnings; clang has others.
set(compiler -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE=-O1)
function (build_sanitized folder)
  build_plain("${folder}" ${compiler} -DISTHMUS_WERROR=OFF -DISTHMUS_TESTING=ON ${ARGN})
endfunction ()

foreach (sanitizer IN LISTS sanitizers)
  message(STATUS "${sanitizer}, share ${share} of the unit tests (0: all)")
  include("${CMAKE_CURRENT_LIST_DIR}/${sanitizer}.cmake")
endforeach ()
