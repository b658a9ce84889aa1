# A module is one static library; its CMakeLists.txt lists its sources, its modules and its outside libraries. What programs
# of others include lies in its folder include/, and takes nothing outside the standard library: they link what LIBRARIES
# names, and do without HEADERS. Nothing of a COLD module is in a hot loop: Debug does not optimise it, which takes half the
# time to compile.
#   flatray_module(geom SOURCES ray.cpp USES base HEADERS Eigen3::Eigen)
function(flatray_module name)
  cmake_parse_arguments(arg "COLD" "" "SOURCES;USES;HEADERS;LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  add_library(flatray_${name} STATIC ${arg_SOURCES})
  add_library(flatray::${name} ALIAS flatray_${name})
  target_include_directories(flatray_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  if(IS_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include)
    target_include_directories(flatray_${name} PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>)
  endif()
  list(TRANSFORM arg_USES PREPEND flatray_ OUTPUT_VARIABLE uses)
  list(TRANSFORM arg_HEADERS REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>" OUTPUT_VARIABLE headers)
  list(TRANSFORM arg_LIBRARIES REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>;$<INSTALL_INTERFACE:$<LINK_ONLY:\\1>>"
    OUTPUT_VARIABLE libraries)
  target_link_libraries(flatray_${name}
    PUBLIC ${uses} ${headers} ${libraries}
    PRIVATE $<BUILD_INTERFACE:flatray_options> ${arg_PRIVATE_LIBRARIES})
  target_compile_features(flatray_${name} PUBLIC cxx_std_20)
  if(arg_COLD AND CMAKE_BUILD_TYPE STREQUAL "Debug")
    target_compile_options(flatray_${name} PRIVATE -O0)
    target_precompile_headers(flatray_${name} REUSE_FROM flatray_unoptimised_pch)
  else()
    target_precompile_headers(flatray_${name} REUSE_FROM flatray_pch)
  endif()
  set_target_properties(flatray_${name} PROPERTIES EXPORT_NAME ${name} UNITY_BUILD_MODE GROUP)
  flatray_unite(own ${arg_SOURCES})
endfunction()

# Of a module that is united, compiles CMAKE_UNITY_BUILD_BATCH_SIZE of these sources at a time as one. By groups, so that what
# is left out of a build never brings others together.
function(flatray_unite group)
  set(count 0)
  foreach(source IN LISTS ARGN)
    math(EXPR batch "${count} / ${CMAKE_UNITY_BUILD_BATCH_SIZE}")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${group}_${batch})
    math(EXPR count "${count} + 1")
  endforeach()
endfunction()

# Compiles the sources of each folder as one instead, so that names need be unlike within a folder alone.
#   flatray_unite_folders(flatray_study experiment.cpp rooms/room.cpp)
function(flatray_unite_folders target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${FLATRAY_UNITY} UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARGN)
    get_filename_component(folder ${source} DIRECTORY)
    get_filename_component(folder "${folder}" NAME)
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${folder})
  endforeach()
endfunction()

# One registered entry: compiles <folder>/<name>.cpp, with sources that it alone needs, and puts it in the table <folder>.inc.
# It is a namespace of its own, as it is compiled as one source with others.
#   flatray_register(scene shapes box)
function(flatray_register module folder name)
  set(entry ${folder}/${name})
  set_property(GLOBAL APPEND PROPERTY FLATRAY_ENTRIES ${entry})
  if(entry IN_LIST FLATRAY_WITHOUT OR (FLATRAY_ONLY AND NOT entry IN_LIST FLATRAY_ONLY))
    set_property(GLOBAL APPEND PROPERTY FLATRAY_ENTRIES_LEFT_OUT ${entry})
    return()
  endif()
  target_sources(flatray_${module} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/${entry}.cpp ${ARGN})
  set_property(TARGET flatray_${module} APPEND PROPERTY FLATRAY_ENTRIES_${folder} ${name})
endfunction()

# After all entries: FLATRAY_ONLY and FLATRAY_WITHOUT name nothing that is not registered, and the program knows what it
# lacks.
function(flatray_finish_entries)
  get_property(entries GLOBAL PROPERTY FLATRAY_ENTRIES)
  foreach(list FLATRAY_ONLY FLATRAY_WITHOUT)
    foreach(entry IN LISTS ${list})
      if(NOT entry IN_LIST entries)
        message(FATAL_ERROR "${list} names ${entry}, which is no registered entry")
      endif()
    endforeach()
  endforeach()
  get_property(left_out GLOBAL PROPERTY FLATRAY_ENTRIES_LEFT_OUT)
  foreach(feature EMBREE MPFR GL HDF5)
    if(NOT FLATRAY_HAVE_${feature})
      list(PREPEND left_out ${feature})
    endif()
  endforeach()
  list(TRANSFORM left_out REPLACE "(.+)" "FLATRAY_LEFT_OUT(\"\\1\")\n")
  list(JOIN left_out "" table)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/src/base/left_out.inc CONTENT "${table}")
endfunction()

# Writes <folder>.inc: the declarations of the entries, and the function that gives them all, sorted. The source whose
# header declares that function includes it in namespace flatray. An entry called NAME defines `entry` in the namespace told.
# REQUIRED: every build has one of them at least. ALONE: each is compiled as a source of its own, as less of one of many is
# inlined.
#   flatray_write_table(scene shapes ShapeType shape_types NAME_shape)
function(flatray_write_table module folder type function space)
  get_property(names TARGET flatray_${module} PROPERTY FLATRAY_ENTRIES_${folder})
  if(NOT names AND "REQUIRED" IN_LIST ARGN)
    message(FATAL_ERROR "FLATRAY_ONLY or FLATRAY_WITHOUT leaves nothing of ${folder}/: keep one entry")
  endif()
  list(SORT names)
  set(declarations "")
  set(addresses "")
  list(TRANSFORM names REPLACE "(.+)" "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/\\1.cpp" OUTPUT_VARIABLE sources)
  if(NOT "ALONE" IN_LIST ARGN)
    flatray_unite(${folder} ${sources})
  endif()
  foreach(name IN LISTS names)
    string(REPLACE NAME ${name} entry ${space})
    string(APPEND declarations "namespace ${entry} { extern const ${type} entry; }\n")
    string(APPEND addresses "&${entry}::entry, ")
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${folder}.inc CONTENT
    "${declarations}std::vector<const ${type}*> ${function}() { return {${addresses}}; }\n")
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

# A module that the program does not link, as it needs a package that few runs need: `flatray_<name>.so`, loaded when it is
# asked for (base/module_file.h). It lies beside the program as built, and in FLATRAY_MODULE_FOLDER where installed.
#   flatray_loaded_module(embree SOURCES embree/module.cpp INCLUDES ... LIBRARIES ...)
set(FLATRAY_MODULE_FOLDER ${CMAKE_INSTALL_LIBDIR}/flatray)
function(flatray_loaded_module name)
  cmake_parse_arguments(arg "" "" "SOURCES;INCLUDES;LIBRARIES;DEFINITIONS" ${ARGN})
  add_library(flatray_${name} MODULE ${arg_SOURCES})
  target_compile_features(flatray_${name} PRIVATE cxx_std_20)
  target_include_directories(flatray_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_include_directories(flatray_${name} SYSTEM PRIVATE ${arg_INCLUDES})
  target_compile_definitions(flatray_${name} PRIVATE ${arg_DEFINITIONS})
  target_link_libraries(flatray_${name} PRIVATE flatray_options ${arg_LIBRARIES})
  target_link_options(flatray_${name} PRIVATE -Wl,--exclude-libs,ALL)  # what it holds of flatray is its own
  if(NOT FLATRAY_SANITIZE)  # clang leaves a sanitizer's own functions to the program that loads the module
    target_link_options(flatray_${name} PRIVATE -Wl,--no-undefined)
  endif()
  set_target_properties(flatray_${name} PROPERTIES PREFIX "" UNITY_BUILD OFF CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
  set_property(GLOBAL APPEND PROPERTY FLATRAY_LOADED_MODULES flatray_${name})
  install(TARGETS flatray_${name} LIBRARY DESTINATION ${FLATRAY_MODULE_FOLDER})
endfunction()
