#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Whether the program as WebAssembly makes the same pictures as the native one: every example, small, by SHA-256 of the file.
# Builds it if it is not there, and the package with it; needs node.
#   test.sh [--smoke] [--chroot FOLDER] PROGRAM [BUILD]
# PROGRAM: the native one. BUILD: the folder of the other (default: build-wasm). --smoke takes ten examples.
# A scene that needs what WebAssembly lacks has to say so; it counts as "left out". Ends with 1 if a picture differs.
set -uo pipefail

own=$(realpath "$(dirname "$0")")
root=$(realpath "$own/../../..")
smoke= chroot=()
while :; do
    case ${1:-} in
        --smoke) smoke=1; shift ;;
        --chroot) chroot=(--chroot "$2"); shift 2 ;;
        *) break ;;
    esac
done
[ $# -ge 1 ] || { sed -n '3,8s/^# //p' "$0"; exit 2; }
program=$(realpath "$1")
build=${2:-$root/build-wasm}
command -v node > /dev/null || { echo "test.sh: node is not installed"; exit 77; }
[ -e "$build/candelabra.wasm" ] || "$own/build.sh" "${chroot[@]}" "$build" || exit 1
[ -e "$build/npm/package/bin/candelabra.js" ] && [ "$build/npm/package/lib/candelabra.wasm" -nt "$build/candelabra.wasm" ] ||
    "$own/../npm/pack.sh" "$build" > /dev/null || exit 1
other=$build/npm/package/bin/candelabra.js

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$root"
if [ -n "$smoke" ]; then
    examples=(examples/lights/{ring,fibonacci_sphere,lens_in_haze}.pov examples/gallery/{ballroom,courtyard,campfire}.pov
              examples/shapes/*.pov examples/looks/*.pov)
    examples=("${examples[@]:0:10}")
else
    mapfile -t examples < <(find examples -name '*.pov' | sort)
fi

cpu() {  # FILE COMMAND...: its CPU seconds go into the file
    local TIMEFORMAT='%U %S' file=$1
    { time "${@:2}" > "$folder/said" 2>&1; } 2> "$file"
}
same=0 different=0 out=0
printf '%-44s %-10s %8s %8s\n' example picture native wasm
for scene in "${examples[@]}"; do
    options=("$scene" +W64 +H48 +FN16 -A --samples 2 --seed 3 +WT1)
    cpu "$folder/t1" "$program" "${options[@]}" "+O$folder/a.png" || { cat "$folder/said"; exit 1; }
    if cpu "$folder/t2" node "$other" "${options[@]}" "+O$folder/b.png"; then
        result=same
        cmp -s "$folder/a.png" "$folder/b.png" || result=DIFFERENT
    elif grep -q 'WebAssembly' "$folder/said"; then
        result="left out"
    else
        result=FAILED
        cat "$folder/said"
    fi
    case $result in same) same=$((same + 1)) ;; "left out") out=$((out + 1)) ;; *) different=$((different + 1)) ;; esac
    printf '%-44s %-10s %8.2f %8.2f\n' "${scene#examples/}" "$result" "$(awk '{ print $1 + $2 }' "$folder/t1")" \
        "$(awk '{ print $1 + $2 }' "$folder/t2")"
done
echo "$same the same, $out left out, $different different (CPU seconds, with the start of node)"
[ "$different" -eq 0 ]
