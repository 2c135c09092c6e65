# What is bundled or compiled in, by what Debian calls it. Included before project(), which stops without a compiler, so that
# one message names all that is missing. Elsewhere than on Linux, vcpkg or the like provides the headers.
if (CMAKE_HOST_UNIX AND NOT CMAKE_HOST_APPLE)
  set(missing)
  find_program(ISTHMUS_COMPILER NAMES "$ENV{CXX}" c++ g++ clang++)
  if (NOT ISTHMUS_COMPILER AND NOT CMAKE_CXX_COMPILER)
    list(APPEND missing g++)
  endif ()
  # Folders of a processor's headers (/usr/include/x86_64-linux-gnu) are known only after project().
  file(GLOB places LIST_DIRECTORIES true /usr/include/*-linux-gnu)
  if (SKBUILD AND NOT EXISTS "${Python3_INCLUDE_DIR}/Python.h")
    list(APPEND missing python3-dev)
  endif ()
  foreach (needed IN ITEMS CGAL/version.h=libcgal-dev Eigen/Core=libeigen3-dev gemmi/pdb.hpp=gemmi-dev
      tao/pegtl.hpp=tao-pegtl-dev nlohmann/json.hpp=nlohmann-json3-dev boost/version.hpp=libboost-dev gmp.h=libgmp-dev
      mpfr.h=libmpfr-dev isa-l/igzip_lib.h=libisal-dev bzlib.h=libbz2-dev zlib.h=zlib1g-dev)
    string(REPLACE "=" ";" needed "${needed}")
    list(GET needed 0 header)
    list(GET needed 1 package)
    # Upstream's gemmi has PEGTL among its own headers.
    find_path(ISTHMUS_FOLDER_OF_${package} NAMES "${header}" "gemmi/third_party/${header}" PATHS /usr/local/include /usr/include ${places} PATH_SUFFIXES eigen3)
    mark_as_advanced(ISTHMUS_FOLDER_OF_${package})
    if (NOT ISTHMUS_FOLDER_OF_${package})
      list(APPEND missing "${package}")
    endif ()
  endforeach ()
  if (missing)
    list(JOIN missing " " missing)
    message(FATAL_ERROR "What the wheel is built from is missing: install Debian's packages, or what provides them elsewhere:\n"
      "  apt install ${missing}")
  endif ()
endif ()
