# cmake --install: the program, and for programs of others the headers of plain arrays, <flatray/trace.h> and so on, the
# libraries behind them, and what find_package(flatray) needs. The targets are flatray::trace, flatray::collide,
# flatray::transport and flatray::render; the other modules are there for them to link.
include(CMakePackageConfigHelpers)

foreach(module base geom trace image scene anim collide transport render)
  if(NOT TARGET flatray_${module})
    continue()
  endif()
  install(TARGETS flatray_${module} EXPORT flatray ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  if(IS_DIRECTORY ${PROJECT_SOURCE_DIR}/src/${module}/include)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${module}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  endif()
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
