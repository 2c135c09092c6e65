include("${CMAKE_CURRENT_LIST_DIR}/Common.cmake")

set(ENV{ASAN_OPTIONS} "detect_leaks=0:allocator_may_return_null=1")
set(folder "${WORK_DIR}/fuzz")
build_plain("${folder}" -DISTHMUS_FUZZ=ON -DISTHMUS_SANITIZE=ON
  -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo)
file(GLOB targets "${folder}/Testing/Fuzz/Fuzz*")
if (NOT targets)
  message(FATAL_ERROR "no fuzz target was built in ${folder}/Testing/Fuzz")
endif ()
foreach (target IN LISTS targets)
  run("${target}" -max_total_time=60 -rss_limit_mb=2048 -timeout=10 -print_final_stats=1)
endforeach ()
