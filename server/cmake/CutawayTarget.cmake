# cutaway_library(NAME SOURCES ... LINKS ... [PRIVATE_LINKS ...])  one folder of server/ as a static library.
# cutaway_test(NAME SOURCES ... LINKS ... [LABELS ...])            one GoogleTest executable, run by ctest.
# cutaway_apart(SOURCES ...)                                       sources that no other is compiled together with.
#
# All presets but dev compile ten sources of a target as one (CMake's unity build): most of a source's time goes into
# the headers that it shares with its neighbours. So a name in an unnamed namespace is free once in a target.

option(CUTAWAY_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
set(CUTAWAY_SANITIZE "" CACHE STRING "Value for -fsanitize=, empty for none")

add_library(cutaway_options INTERFACE)
target_compile_features(cutaway_options INTERFACE cxx_std_20)
target_compile_options(cutaway_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
  -Wno-missing-field-initializers  # designated initialisers leave the rest at its defaults
  # gcc 12's flow analysis sees these in the standard library where there are none (PR 105329, 105562, 105651).
  -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread
  $<$<BOOL:${CMAKE_UNITY_BUILD}>:-Wno-maybe-uninitialized>  # the same in a std::variant, where more is inlined; dev has it
  $<$<CXX_COMPILER_ID:Clang>:-Wno-unknown-warning-option>
  $<$<BOOL:${CUTAWAY_WARNINGS_AS_ERRORS}>:-Werror>)
if(CUTAWAY_SANITIZE MATCHES "undefined")
  # Else it is only said, and the test that did it passes.
  target_compile_options(cutaway_options INTERFACE -fno-sanitize-recover=undefined)
endif()
if(CUTAWAY_SANITIZE)
  target_compile_options(cutaway_options INTERFACE -fsanitize=${CUTAWAY_SANITIZE} -fno-omit-frame-pointer
    -Wno-maybe-uninitialized)  # PR 105562 again: std::regex under the sanitizers
  # The sanitizer's own dlopen asks the program's RPATH for cutaway-images.so, but not its RUNPATH.
  target_link_options(cutaway_options INTERFACE -fsanitize=${CUTAWAY_SANITIZE} -Wl,--disable-new-dtags)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

function(cutaway_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

function(cutaway_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/server)
  target_link_libraries(${name} PUBLIC ${ARG_LINKS} PRIVATE cutaway_options ${ARG_PRIVATE_LINKS})
  target_compile_features(${name} PUBLIC cxx_std_20)
endfunction()

function(cutaway_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;LABELS" ${ARGN})
  find_package(GTest REQUIRED)
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE cutaway_options ${ARG_LINKS} GTest::gtest GTest::gmock GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  # Half the time to build; the tests are as fast.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  if(CUTAWAY_SANITIZE)
    target_compile_options(${name} PRIVATE -O0)
  endif()
  add_test(NAME ${name} COMMAND ${name})
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 600)
  # A software renderer keeps all cores busy: such a test runs alone, others two at a time.
  if("gpu" IN_LIST ARG_LABELS)
    set_tests_properties(${name} PROPERTIES RUN_SERIAL ON)
  endif()
endfunction()
