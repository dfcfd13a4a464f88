# What most sources include of libraries takes longer to read than the sources: compiled once, for the
# modules and, with GoogleTest's, for the tests.
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/library_headers.cpp CONTENT "")

# library_headers(NAME HEADER... LIBRARIES TARGET...)
function(library_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES")
  add_library(${name} STATIC ${CMAKE_BINARY_DIR}/library_headers.cpp)
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${arg_UNPARSED_ARGUMENTS})
  morphgrid_compile_options(${name})
endfunction()

set(often_included <Eigen/Geometry> <filesystem> <fmt/format.h> <fstream> <functional> <nlohmann/json.hpp>)
set(their_libraries Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json spdlog::spdlog)
library_headers(module_headers ${often_included} LIBRARIES ${their_libraries})
library_headers(test_headers ${often_included} <gmock/gmock.h> <gtest/gtest.h> LIBRARIES ${their_libraries} GTest::gmock)

# morphgrid_test_options(TARGET): tests take longer to optimise than to run. All as their headers, or GCC
# refuses these.
function(morphgrid_test_options target)
  # At this level GCC 12 has false alarms about std::string and Eigen.
  target_compile_options(${target} PRIVATE "$<$<CONFIG:Release>:-O1;-Wno-array-bounds;-Wno-maybe-uninitialized>"
                                           "$<$<BOOL:${MORPHGRID_SANITIZE}>:-O0>")
  if(NOT target STREQUAL test_headers)
    morphgrid_compile_options(${target})
    target_precompile_headers(${target} REUSE_FROM test_headers)
  endif()
endfunction()
morphgrid_test_options(test_headers)
