# SPDX-License-Identifier: GPL-3.0-or-later
# The words of the language as a dictionary for fuzzers: cmake -DPROGRAM=... -DOUTPUT=... -P dictionary.cmake
execute_process(COMMAND ${PROGRAM} --describe words json OUTPUT_VARIABLE json COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\"[a-z0-9_]+\"" words "${json}")
foreach(sign "#declare A = " "#macro M(A)" "#if (1)" "#else" "#end" "#for (I, 1, 3)" "#while (0)" "#switch (1)"
        "#case (1)" "M(1)" "{" "}" "(" ")" "<" ">" "[" "]" "1e9" "-1" "A" "array[2]" "<0, 1, 2>" "rgb 1")
  list(APPEND words "\"${sign}\"")
endforeach()
list(JOIN words "\n" text)
file(WRITE ${OUTPUT} "${text}\n")
