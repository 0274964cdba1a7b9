#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tries laws of light on scenes that are made for it, and writes those that break one into a folder.
#   run.sh [--minutes N] [--law NAME]... [--seed S] [--scenes N] [--out FOLDER]
# The program is built if necessary (BUILD_DIR: default build). A scene that ends the program is kept, and the run goes on
# with the next seed.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${BUILD_DIR:-$root/build}

minutes=10 seed=1 out=proof.out rest=()
while [ $# -gt 0 ]; do
    case $1 in
        --minutes) minutes=$2 ;;
        --seed) seed=$2 ;;
        --out) out=$2 ;;
        --law | --scenes | --seconds | --shrink) rest+=("$1" "$2") ;;
        *) echo "run.sh: there is no \`$1\`; see the head of the script" >&2; exit 2 ;;
    esac
    shift 2
done

[ -e "$build/build.ninja" ] || cmake -S "$root" -B "$build" -G Ninja -DCANDELABRA_TESTS=ON
cmake --build "$build" --target proof
mkdir -p "$out"
end=$((SECONDS + minutes * 60)) status=0
while [ $SECONDS -lt $end ]; do
    left=$(((end - SECONDS + 59) / 60)) ended=0
    nice "$build/tests/proof/proof" --minutes "$left" --seed "$seed" --out "$out" "${rest[@]}" || ended=$?
    if [ $ended -le 2 ]; then
        [ $ended -eq 0 ] || status=$ended
        break
    fi
    cp "$out/last.pov" "$out/ended-$seed.pov"
    echo "the program ended with $ended at $out/ended-$seed.pov"
    status=1 seed=$((seed + 1))
done
exit $status
