# find_package(Isthmus): targets and module properties of the installed tree.

include(CMakePackageConfigHelpers)

# Of each module, by component: the components of Isthmus and of VTK that it needs.
get_property(modules GLOBAL PROPERTY isthmus_modules)
set(ISTHMUS_COMPONENTS)
set(ISTHMUS_COMPONENT_DEPENDS "")
foreach (module IN LISTS modules)
  string(REPLACE "Isthmus::" "" component "${module}")
  list(APPEND ISTHMUS_COMPONENTS "${component}")
  set(own)
  set(foreign)
  foreach (property IN ITEMS depends private_depends)
    get_property(needed GLOBAL PROPERTY "_vtk_module_${module}_${property}")
    foreach (name IN LISTS needed)
      if (name MATCHES "^Isthmus::(.+)$")
        list(APPEND own "${CMAKE_MATCH_1}")
      elseif (name MATCHES "^VTK::(.+)$")
        list(APPEND foreign "${CMAKE_MATCH_1}")
      endif ()
    endforeach ()
  endforeach ()
  string(APPEND ISTHMUS_COMPONENT_DEPENDS
    "set(_isthmus_${component}_needs ${own})\nset(_isthmus_${component}_vtk ${foreign})\n")
endforeach ()
string(REPLACE ";" " " ISTHMUS_COMPONENT_DEPENDS "${ISTHMUS_COMPONENT_DEPENDS}")

set(package_destination "${CMAKE_INSTALL_LIBDIR}/cmake/Isthmus")
configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/cmake/IsthmusConfig.cmake.in"
  "${CMAKE_CURRENT_BINARY_DIR}/IsthmusConfig.cmake"
  INSTALL_DESTINATION "${package_destination}")
write_basic_package_version_file(
  "${CMAKE_CURRENT_BINARY_DIR}/IsthmusConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${CMAKE_CURRENT_BINARY_DIR}/IsthmusConfig.cmake"
  "${CMAKE_CURRENT_BINARY_DIR}/IsthmusConfigVersion.cmake"
  "${CMAKE_CURRENT_SOURCE_DIR}/cmake/IsthmusParaView.cmake"
  DESTINATION "${package_destination}")
install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/Isthmus")
