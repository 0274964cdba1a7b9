#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Puts deliberate faults into a clone, one at a time, and says how long the machine takes to find each.
#   faults.sh [--clone FOLDER] [--minutes N] [--seed S] [--law NAME]... [FAULT]...
#   faults.sh --check             only says whether all patches still fit
# A fault may take N minutes (default: 10); the seconds that are said are of CPU time, which others do not disturb.
# FAULT is the name of a patch in faults/ (default: all of them). The clone is made if necessary, is built in its folder
# build/, and is clean again in the end. The exit status is 1 if a fault is not found in the time (default: 10 minutes).
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
clone=$root/build/faults minutes=10 seed=1 names=() laws=()
if [ "${1:-}" = --check ]; then
    command -v patch > /dev/null || exit 77
    cd "$root"
    for patch in tests/proof/faults/*.patch; do
        patch -p1 -F0 --dry-run --silent < "$patch" || { echo "$patch does not fit; make it anew"; exit 1; }
    done
    exit
fi
while [ $# -gt 0 ]; do
    case $1 in
        --clone) clone=$2; shift ;;
        --minutes) minutes=$2; shift ;;
        --seed) seed=$2; shift ;;
        --law) laws+=(--law "$2"); shift ;;
        -*) echo "faults.sh: there is no \`$1\`; see the head of the script" >&2; exit 2 ;;
        *) names+=("$1") ;;
    esac
    shift
done
[ ${#names[@]} -gt 0 ] || for patch in "$root"/tests/proof/faults/*.patch; do names+=("$(basename "$patch" .patch)"); done

[ -e "$clone" ] || git clone -q --shared "$root" "$clone"
clone=$(cd "$clone" && pwd)
[ -e "$clone/build/build.ninja" ] || cmake -S "$clone" -B "$clone/build" -G Ninja -DCANDELABRA_TESTS=ON > "$clone/cmake.log"
patch=
restore() { [ -z "$patch" ] || git -C "$clone" apply -R "$patch"; patch=; }
trap restore EXIT

status=0 TIMEFORMAT=%U
echo "| fault | found by | after CPU s | scenes |"
echo "|---|---|---|---|"
for name in "${names[@]}"; do
    patch=$root/tests/proof/faults/$name.patch
    git -C "$clone" apply "$patch" || { patch=; exit 1; }
    ninja -C "$clone/build" proof > "$clone/build/faults.log" || { tail -20 "$clone/build/faults.log"; exit 1; }
    used=$({ time { (cd "$clone" && build/tests/proof/proof --first --shrink 0 --minutes "$minutes" --seed "$seed" \
        "${laws[@]}" --out build/proof.out) > "$clone/build/faults.log" 2>&1 || true; }; } 2>&1)
    scenes=$(awk -F'|' '$3 ~ /^ [0-9]+ $/ {sum += $3} END {print sum + 0}' "$clone/build/faults.log")
    law=$(awk -F'|' '$6 ~ /^ [1-9][0-9]* $/ {print $2; exit}' "$clone/build/faults.log")
    [ -n "$law" ] || { law=" nothing "; status=1; }
    echo "| $name |$law| ${used%.*} | $scenes |"
    restore
done
exit $status
