# What `cmake --install` puts where: the program (with its man pages and macros), and for other programs the libraries up
# to run and analyze with headers and find_package(frit). The reports stay inside: nobody else needs cairo.
include(CMakePackageConfigHelpers)
set(frit_exported core state solve neighbor contact network integrate observe generate io config run analyze)
set(frit_package lib/cmake/frit)
foreach(rung ${frit_exported})
  set_target_properties(frit_${rung} PROPERTIES EXPORT_NAME ${rung})
  install(TARGETS frit_${rung} EXPORT frit_targets ARCHIVE DESTINATION lib COMPONENT development)
  install(DIRECTORY src/${rung} DESTINATION include/frit COMPONENT development FILES_MATCHING PATTERN "*.hpp")
endforeach()
set_target_properties(frit_flags PROPERTIES EXPORT_NAME flags)
install(TARGETS frit_flags EXPORT frit_targets)
install(EXPORT frit_targets NAMESPACE frit:: DESTINATION ${frit_package} COMPONENT development)
configure_package_config_file(cmake/frit-config.cmake.in ${PROJECT_BINARY_DIR}/frit-config.cmake
  INSTALL_DESTINATION ${frit_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/frit-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/frit-config.cmake ${PROJECT_BINARY_DIR}/frit-config-version.cmake
  DESTINATION ${frit_package} COMPONENT development)

install(FILES LICENSE DESTINATION share/doc/frit RENAME copyright COMPONENT program)
install(FILES README.md CHANGELOG.md DESTINATION share/doc/frit COMPONENT program)
install(DIRECTORY docs cases examples DESTINATION share/doc/frit COMPONENT program)

# cpack takes what has been built and builds nothing: tests call it while others may build.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
# `cpack -G DEB` in the build folder makes the Debian package of the program; docs/install.md.
set(CPACK_PACKAGE_NAME frit)
set(CPACK_PACKAGE_CONTACT "The frit developers <frit@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3 (>= 3.11), python3 (<< 3.12), python3-numpy")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-matplotlib, paraview")
include(CPack)
