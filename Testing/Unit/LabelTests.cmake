# Run by ctest for each unit program: labels of its `tests`. Those of a suite X are X_labels; suites in
# `data_suites` read shared data; `long_tests` are names of turns.tsv.
cmake_policy(SET CMP0057 NEW) # if (... IN_LIST ...), which ctest does not know without it
foreach (test IN LISTS tests)
  string(REGEX REPLACE "^(.*/)?([A-Za-z0-9]+)[.].*$" "\\2" suite "${test}")
  set(labels ${${suite}_labels})
  if (suite IN_LIST data_suites)
    list(APPEND labels data)
  endif ()
  string(REGEX REPLACE "/[^/]*$" "/*" instances "${test}")
  if (test IN_LIST long_tests OR instances IN_LIST long_tests)
    list(APPEND labels long)
  endif ()
  set_tests_properties("${test}" PROPERTIES LABELS "${labels}")
endforeach ()
