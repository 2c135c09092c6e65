# `cpack -G DEB` in the build tree: one Debian package with the library, the plugin where Debian's
# ParaView loads it by itself, the Python module, headers and CMake files.

set(CPACK_PACKAGE_NAME "isthmus")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_CONTACT "Isthmus maintainers <maintainers@isthmus.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "geometry and topology of density maps and proteins in ParaView")
set(CPACK_PACKAGING_INSTALL_PREFIX "/usr")
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_SOURCE_DIR}/cmake/package/layout.cmake")
set(CPACK_ISTHMUS_COPYRIGHT "${CMAKE_CURRENT_SOURCE_DIR}/cmake/package/copyright")
configure_file("${CMAKE_CURRENT_SOURCE_DIR}/cmake/package/changelog"
  "${CMAKE_CURRENT_BINARY_DIR}/package/changelog" @ONLY)
set(CPACK_ISTHMUS_CHANGELOG "${CMAKE_CURRENT_BINARY_DIR}/package/changelog")

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION "science")
set(CPACK_DEBIAN_PACKAGE_HOMEPAGE "")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What no binary links to: the window, its Python, the program that makes tetrahedra, and icons, which
# a root without recommended packages does not show (seen in one). A plugin belongs to one ParaView.
math(EXPR next_minor "${ParaView_VERSION_MINOR} + 1")
set(paraview_here "${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}")
set(icons libqt5svg5) # ParaView 5.11; from 5.13 on it says which Qt it uses
if (PARAVIEW_QT_MAJOR_VERSION EQUAL 6)
  set(icons qt6-svg-plugins)
endif ()
string(CONCAT CPACK_DEBIAN_PACKAGE_DEPENDS
  "paraview (>= ${paraview_here}), paraview (<< ${ParaView_VERSION_MAJOR}.${next_minor}~), "
  "python3-paraview, tetgen, ${icons}")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "apbs")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA
  "${CMAKE_CURRENT_SOURCE_DIR}/cmake/package/triggers" "${CMAKE_CURRENT_SOURCE_DIR}/cmake/package/prerm")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Readers and filters for cryo-EM maps, proteins and closed surfaces: denoising,
surfaces, curvature, electrostatics at the surface, likely binding sites, and
choking loops, the rings where a shape narrows; a toolbar that builds whole
pipelines from them.")

include(CPack)
