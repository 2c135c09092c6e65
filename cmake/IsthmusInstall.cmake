# find_package(Isthmus): targets and module properties of the installed tree.

include(CMakePackageConfigHelpers)

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
  DESTINATION "${package_destination}")
install(FILES "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/Isthmus")
