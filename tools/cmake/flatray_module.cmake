# A module is one static library; its CMakeLists.txt lists its sources, its modules and its outside libraries:
#   flatray_module(geom SOURCES ray.cpp USES base LIBRARIES Eigen3::Eigen)
function(flatray_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;USES;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  add_library(flatray_${name} STATIC ${arg_SOURCES})
  add_library(flatray::${name} ALIAS flatray_${name})
  target_include_directories(flatray_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:include/flatray>)
  list(TRANSFORM arg_USES PREPEND flatray_ OUTPUT_VARIABLE uses)
  target_link_libraries(flatray_${name}
    PUBLIC ${uses} ${arg_LIBRARIES}
    PRIVATE $<BUILD_INTERFACE:flatray_options> ${arg_PRIVATE_LIBRARIES})
  target_compile_features(flatray_${name} PUBLIC cxx_std_20)
  target_precompile_headers(flatray_${name} REUSE_FROM flatray_pch)
  set_property(TARGET flatray_${name} PROPERTY EXPORT_NAME ${name})
endfunction()

# One registered entry: compiles <folder>/<name>.cpp and puts it in the table <folder>.inc.
#   flatray_register(scene shapes box)
function(flatray_register module folder name)
  if(NOT "${folder}/${name}" IN_LIST FLATRAY_WITHOUT)
    target_sources(flatray_${module} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${name}.cpp)
    set_property(TARGET flatray_${module} APPEND PROPERTY FLATRAY_ENTRIES_${folder} ${name})
  endif()
endfunction()

# Writes <folder>.inc, a line FLATRAY_ENTRY(name) each, sorted. One source includes it twice: to declare the
# entries and to fill the table.
function(flatray_write_table module folder)
  get_property(names TARGET flatray_${module} PROPERTY FLATRAY_ENTRIES_${folder})
  list(SORT names)
  list(TRANSFORM names REPLACE "(.+)" "FLATRAY_ENTRY(\\1)\n")
  list(JOIN names "" table)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${folder}.inc CONTENT "${table}")
  target_include_directories(flatray_${module} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
endfunction()

# Kernels: <folder>/<tier>.cpp for each tier, each with its own instruction set and nothing precompiled.
function(flatray_kernels module folder)
  set(flags_portable -fno-tree-vectorize)
  set(flags_baseline "")
  set(flags_avx2 -mavx2 -mfma)
  set(flags_avx512 -mavx512f -mavx512dq -mavx512vl -mavx512bw -mfma)
  set(tiers portable)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND tiers baseline avx2 avx512)
  endif()
  foreach(tier ${tiers})
    set(source ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${tier}.cpp)
    target_sources(flatray_${module} PRIVATE ${source})
    set_source_files_properties(${source} PROPERTIES
      SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "${flags_${tier}}")
  endforeach()
endfunction()
