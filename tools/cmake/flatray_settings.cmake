# What every target is compiled with.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug" FORCE)
endif()
option(FLATRAY_TESTS "build the tests" ${PROJECT_IS_TOP_LEVEL})
set(FLATRAY_TEST_SHARDS 0 CACHE STRING "processes that share the tests of a program; 0: each test has its own")
option(FLATRAY_BENCHMARKS "build the comparisons with other libraries" OFF)
option(FLATRAY_WERROR "warnings are errors" OFF)
option(FLATRAY_FUZZ "build the fuzz targets of tests/fuzz with clang's libFuzzer" OFF)
set(FLATRAY_SANITIZE "" CACHE STRING "sanitizers, as -fsanitize takes them")
set(FLATRAY_WITHOUT "" CACHE STRING "registered entries to leave out, as folder/name")
set(FLATRAY_ONLY "" CACHE STRING "registered entries to keep, as folder/name, all others left out; empty keeps all")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# Where a folder sets CMAKE_UNITY_BUILD, twelve of its sources, or as many as it says, are compiled as one, which takes half
# the time, and those of `study` folder by folder; whoever changes one file again and again may turn it off.
option(FLATRAY_UNITY "compile several sources of most modules and of the tests as one" ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 12)
if(FLATRAY_SANITIZE)  # compiled sooner, and what is inlined matters less
  set(CMAKE_UNITY_BUILD_BATCH_SIZE 24)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O2 -g1")

add_library(flatray_options INTERFACE)
target_compile_options(flatray_options INTERFACE
  -ffp-contract=off  # a fused multiply-add would change bits between machines
  -fno-math-errno    # sqrt is one instruction
  $<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>  # so that a cache of compilations can hold them
  -fPIC              # the libraries may go into shared ones; the same for all, for the precompiled header
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wdouble-promotion
  # g++ 12 sees the first two in the standard library's own variant, optional and string; the third it says of any source
  # that is compiled as one with others.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-array-bounds;-Wno-subobject-linkage>
  $<$<BOOL:${FLATRAY_WERROR}>:-Werror>)
if(FLATRAY_SANITIZE)
  target_compile_options(flatray_options INTERFACE
    -fsanitize=${FLATRAY_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer
    # What the address sanitizer stops at, too; without these checks clang compiles an eighth to a fifth faster.
    -fno-sanitize=null,object-size,vptr)
  target_link_options(flatray_options INTERFACE -fsanitize=${FLATRAY_SANITIZE})
endif()

include(GNUInstallDirs)  # where things are installed to
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(tl-expected REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_path(STB_INCLUDE_DIR stb_image_write.h PATH_SUFFIXES stb REQUIRED)
find_path(GMP_INCLUDE_DIR gmp.h REQUIRED)
find_library(GMP_LIBRARY gmp REQUIRED)
find_path(SLEEF_INCLUDE_DIR sleef.h REQUIRED)
find_library(SLEEF_LIBRARY sleef REQUIRED)

# One precompiled header for all modules: what nearly every source includes. Debug has another, for those it does not optimise.
foreach(pch flatray_pch flatray_unoptimised_pch)
  add_library(${pch} STATIC EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/tools/cmake/pch.cpp)
  target_link_libraries(${pch} PUBLIC flatray_options Eigen3::Eigen fmt::fmt tl::expected)
  target_precompile_headers(${pch} PRIVATE
    <algorithm> <array> <cmath> <cstdint> <functional> <memory> <optional> <span> <string>
    <string_view> <utility> <variant> <vector> <Eigen/Core> <fmt/core.h> <tl/expected.hpp>)
endforeach()
target_compile_options(flatray_unoptimised_pch PRIVATE -O0)
