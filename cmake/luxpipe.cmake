# SPDX-License-Identifier: BSD-3-Clause
# The four words our CMake files use.  Sources are listed by name.

# lux_library(name SOURCES ... LINK ...): static library lux_<name>; includes are "NAME/file.h".
function(lux_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(lux_${name} STATIC ${ARG_SOURCES})
  target_include_directories(lux_${name} PUBLIC ${PROJECT_SOURCE_DIR}/lib)
  target_link_libraries(lux_${name} PUBLIC ${ARG_LINK})
endfunction()

# lux_tool(name SOURCES ... LINK ...): the program <name>, installed to bin.
function(lux_tool name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  target_compile_definitions(${name} PRIVATE LUXPIPE_VERSION="${LUXPIPE_VERSION_TEXT}")
  if(WIN32)
    target_sources(${name} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/windows.rc)  # UTF-8
  endif()
  install(TARGETS ${name} RUNTIME DESTINATION bin)
endfunction()

# lux_test(name SOURCES ... LINK ...): a doctest program, run by ctest as <name>.
# Files it reads are found below LUXPIPE_TESTS (the tests/ folder).
function(lux_test name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests ${PROJECT_SOURCE_DIR}/lib)
  target_compile_definitions(${name} PRIVATE LUXPIPE_TESTS="${PROJECT_SOURCE_DIR}/tests")
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  add_test(NAME ${name} COMMAND ${name})
endfunction()

# lux_script_test(name script): a shell test; PATH starts with the built tools.
function(lux_script_test name script)
  add_test(NAME ${name} COMMAND bash ${CMAKE_CURRENT_SOURCE_DIR}/${script})
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77 ENVIRONMENT
    "PATH=${CMAKE_BINARY_DIR}/bin:$ENV{PATH};TOP=${PROJECT_SOURCE_DIR};BIN=${CMAKE_BINARY_DIR}/bin")
endfunction()
