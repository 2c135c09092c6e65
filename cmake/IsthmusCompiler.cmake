# isthmus_compiler: what our own files (never wrapped or generated ones) are compiled with.

add_library(isthmus_compiler INTERFACE)
target_compile_options(isthmus_compiler INTERFACE
  "$<$<NOT:$<CXX_COMPILER_ID:MSVC>>:-Wall;-Wextra;-Wshadow;-Wconversion>"
  # In groups of sources, types of unnamed namespaces are not in the main file; they stay in one group.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>
  $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion> # which GCC's -Wconversion leaves out in C++
  $<$<BOOL:${ISTHMUS_WERROR}>:-Werror>)

if (ISTHMUS_SANITIZE)
  # Every target of the project, since mixed binaries give false reports.
  add_compile_options(
    -fsanitize=${ISTHMUS_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${ISTHMUS_SANITIZE})
endif ()

if (ISTHMUS_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
  add_link_options(-fsanitize=fuzzer-no-link)
endif ()
