# SPDX-License-Identifier: GPL-3.0-or-later
# Makes a manual page: cmake -DPROGRAM=... -DVERSION=... -DINPUT=page.in -DOUTPUT=page -P generate.cmake
# A page in Markdown (page.md) is converted first. Each @PART@ of the page is replaced by what the program says about that
# part of itself.
cmake_minimum_required(VERSION 3.25)
if(INPUT MATCHES "\\.md$")
  find_program(AWK awk REQUIRED)
  execute_process(COMMAND ${AWK} -f ${CMAKE_CURRENT_LIST_DIR}/markdown.awk ${INPUT} OUTPUT_VARIABLE page
                  COMMAND_ERROR_IS_FATAL ANY)
else()
  file(READ ${INPUT} page)
endif()
string(REPLACE "@VERSION@" "${VERSION}" page "${page}")

foreach(part options compatibility items functions glossary macros missing words warnings)
  string(TOUPPER "@${part}@" place)
  string(FIND "${page}" "${place}" found)
  if(found EQUAL -1)
    continue()
  endif()
  execute_process(COMMAND ${PROGRAM} --describe roff ${part}
                  OUTPUT_VARIABLE table OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "${place}" "${table}" page "${page}")
endforeach()
file(WRITE ${OUTPUT} "${page}")
