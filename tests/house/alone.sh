#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Each source and each header compiles by itself: it includes the headers of the program that it uses. (Those of the standard
# library are all there, for speed; includes_test.cpp looks after them.) Takes eight minutes of two cores.
#   alone.sh BUILD [FILE...]     BUILD: the build folder, which has the generated headers; FILE: only these, relative to src/
# CXX chooses the compiler.
set -euo pipefail
build=$(realpath "$1")
shift
cd "$(dirname "$0")/../../src"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

export flags="-std=c++20 -fsyntax-only -w -I$PWD -I$build/grammar $(pkg-config --cflags freetype2 2> /dev/null || echo -I/usr/include/freetype2) -DCANDELABRA_VERSION=\"\" -DCANDELABRA_SOURCE_STDLIB=\"\" -DCANDELABRA_JPEG"
export CXX=${CXX:-g++} folder

# Headers of the standard library and of GLM, whose parsing would take most of the time.
{
    cat ./*/*.h ./*/*.cpp | grep -ohE '^#include <([a-z_]+|glm/[a-z_0-9]+\.hpp|nlohmann/json\.hpp)>' | sort -u
} > "$folder/all.h"
$CXX ${flags/-fsyntax-only/} -x c++-header "$folder/all.h" -o "$folder/all.h.gch"

# A header is compiled by its source, if that includes it first.
seen_by_source() {
    local source=${1%.h}.cpp
    [ -e "$source" ] && [ "$(grep -m1 '^#include' "$source")" = "#include \"$1\"" ]
}
files=("$@")
if [ ${#files[@]} -eq 0 ]; then
    for file in */*.h */*.cpp; do
        case $file in
            # Most of these is CGAL, and takes 20 seconds each; CMAKE_UNITY_BUILD=OFF compiles them one by one.
            cgal/*) [ "${file%.h}" != "$file" ] && grep -q '<CGAL/' "$file" && continue
                    [ "${file%.cpp}" != "$file" ] && grep -q 'operations.h\|<CGAL/' "$file" && continue ;;
        esac
        [ "${file%.h}" = "$file" ] || ! seen_by_source "$file" || continue
        files+=("$file")
    done
fi

check() {
    echo "#include \"$1\"" | $CXX $flags -include "$folder/all.h" -x c++ - > "$folder/said.$$" 2>&1 ||
        { echo "$1 does not compile by itself:"; cat "$folder/said.$$"; exit 1; }
}
export -f check
printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 1 bash -c 'check "$0"'
echo "${#files[@]} files compile by themselves"
