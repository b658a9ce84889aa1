# cmake --install: libraries, headers, the program, and what find_package(flatray) needs.
# The targets are flatray::geom, flatray::trace and so on, one for each module.
include(CMakePackageConfigHelpers)

foreach(module base geom trace image scene anim collide transport precise render oracle study app)
  if(NOT TARGET flatray_${module})
    continue()
  endif()
  install(TARGETS flatray_${module} EXPORT flatray ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${module} DESTINATION include/flatray
    FILES_MATCHING PATTERN "*.h")
endforeach()
if(TARGET flatray)
  set_property(TARGET flatray PROPERTY RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})  # build/release/flatray
  install(TARGETS flatray RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/flatray)
install(EXPORT flatray NAMESPACE flatray:: FILE flatrayTargets.cmake DESTINATION ${package_dir})
configure_package_config_file(${PROJECT_SOURCE_DIR}/tools/cmake/flatrayConfig.cmake.in
  ${PROJECT_BINARY_DIR}/flatrayConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/flatrayConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/flatrayConfig.cmake ${PROJECT_BINARY_DIR}/flatrayConfigVersion.cmake
  DESTINATION ${package_dir})
