# Writes HEADER with version, git state and flags. Runs at every build, so that the git state is that of the
# compiled sources; the header is written only if it changes. Variables: HEADER SOURCE_DIR
# VERSION DEAL_II BUILD_TYPE FLAGS.
set(git "unknown")
find_package(Git QUIET)
if(GIT_FOUND)
  # An unpacked archive may lie inside another repository, whose state is not that of these sources.
  execute_process(COMMAND ${GIT_EXECUTABLE} rev-parse --show-prefix WORKING_DIRECTORY ${SOURCE_DIR}
    OUTPUT_VARIABLE prefix OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed AND prefix STREQUAL "")
    execute_process(COMMAND ${GIT_EXECUTABLE} --no-optional-locks describe --always --dirty
      WORKING_DIRECTORY ${SOURCE_DIR}
      OUTPUT_VARIABLE state OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
    if(NOT failed)
      set(git "${state}")
    endif()
  endif()
endif()

string(STRIP "${FLAGS}" FLAGS)
set(text "#pragma once\n// Written by cmake/provenance.cmake.\n")
foreach(pair "VERSION=${VERSION}" "DEAL_II=${DEAL_II}" "GIT=${git}" "BUILD_TYPE=${BUILD_TYPE}"
    "FLAGS=${FLAGS}")
  string(REGEX MATCH "^([A-Z_]+)=(.*)$" whole "${pair}")
  string(REGEX REPLACE "([\\\"])" "\\\\\\1" value "${CMAKE_MATCH_2}")
  string(REGEX MATCH "^[A-Z_]+" key "${pair}")
  string(APPEND text "#define FEMSPH_${key} \"${value}\"\n")
endforeach()

set(before "")
if(EXISTS ${HEADER})
  file(READ ${HEADER} before)
endif()
if(NOT text STREQUAL before)
  file(WRITE ${HEADER} "${text}")
endif()
