# What is bundled or compiled in, by what Debian calls it; asked for before the packages
# that need each other and before anything is downloaded.
foreach (needed IN ITEMS CGAL/version.h=libcgal-dev Eigen/Core=libeigen3-dev gemmi/pdb.hpp=gemmi-dev
    tao/pegtl.hpp=tao-pegtl-dev nlohmann/json.hpp=nlohmann-json3-dev boost/version.hpp=libboost-dev gmp.h=libgmp-dev mpfr.h=libmpfr-dev
    isa-l/igzip_lib.h=libisal-dev bzlib.h=libbz2-dev)
  string(REPLACE "=" ";" needed "${needed}")
  list(GET needed 0 header)
  list(GET needed 1 package)
  find_path(ISTHMUS_FOLDER_OF_${package} "${header}" PATH_SUFFIXES eigen3 ${CMAKE_LIBRARY_ARCHITECTURE})
  mark_as_advanced(ISTHMUS_FOLDER_OF_${package})
  if (NOT ISTHMUS_FOLDER_OF_${package})
    message(FATAL_ERROR "The header ${header} was not found: install Debian's package ${package}, or what provides it.")
  endif ()
endforeach ()
