# Installs the library: component `runtime` has what programs need, `dev` what is needed to build them.
include(CMakePackageConfigHelpers)

set(gcpw_config_dir "${CMAKE_INSTALL_LIBDIR}/cmake/gcpw")
install(TARGETS gcpw EXPORT gcpw
    RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT runtime
    LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime NAMELINK_COMPONENT dev
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT dev)
install(DIRECTORY include/opencv2 DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT dev FILES_MATCHING PATTERN "*.hpp")
install(EXPORT gcpw NAMESPACE gcpw:: FILE gcpwTargets.cmake DESTINATION "${gcpw_config_dir}" COMPONENT dev)
configure_package_config_file(cmake/gcpwConfig.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/gcpwConfig.cmake"
    INSTALL_DESTINATION "${gcpw_config_dir}")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/gcpwConfigVersion.cmake"
    VERSION ${GCPW_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/gcpwConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/gcpwConfigVersion.cmake"
    DESTINATION "${gcpw_config_dir}" COMPONENT dev)

cmake_path(IS_ABSOLUTE CMAKE_INSTALL_LIBDIR gcpw_libdir_is_absolute)
cmake_path(IS_ABSOLUTE CMAKE_INSTALL_INCLUDEDIR gcpw_includedir_is_absolute)
set(gcpw_pc_libdir "${CMAKE_INSTALL_LIBDIR}")
set(gcpw_pc_includedir "${CMAKE_INSTALL_INCLUDEDIR}")
if(NOT gcpw_libdir_is_absolute)
    set(gcpw_pc_libdir "\${prefix}/${CMAKE_INSTALL_LIBDIR}")
endif()
if(NOT gcpw_includedir_is_absolute)
    set(gcpw_pc_includedir "\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}")
endif()
# Where the package lies tells the prefix, wherever it was moved to.
file(RELATIVE_PATH gcpw_pc_up "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file(cmake/gcpw.pc.in "${CMAKE_CURRENT_BINARY_DIR}/gcpw.pc" @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/gcpw.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT dev)
