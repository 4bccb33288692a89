# SPDX-License-Identifier: BSD-3-Clause
# LUXPIPE_VERSION_TEXT, which programs print and pictures carry (SOFTWARE=): the project's version, and between releases
# the number of commits and the last one, 0.1.0+512.g8c88685, with ".changed" where files differ from it.
# In a tarball, or where git is missing, the project's version alone.  Read when CMake is run, as `make all` does.
set(LUXPIPE_VERSION_TEXT ${PROJECT_VERSION})

function(ask_git result)
  execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} ${ARGN}
    OUTPUT_VARIABLE text RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT status EQUAL 0)
    set(text "")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

if(EXISTS ${PROJECT_SOURCE_DIR}/.git)  # not some folder above, which would be another project's
  ask_git(tag describe --tags --exact-match --match v${PROJECT_VERSION} --dirty)
  ask_git(commit rev-parse --short=9 HEAD)
  ask_git(count rev-list --count HEAD)
  ask_git(changes status --porcelain --untracked-files=no)
  if(commit AND NOT tag STREQUAL "v${PROJECT_VERSION}")
    string(APPEND LUXPIPE_VERSION_TEXT "+${count}.g${commit}")
    if(changes)
      string(APPEND LUXPIPE_VERSION_TEXT ".changed")
    endif()
  endif()
endif()
