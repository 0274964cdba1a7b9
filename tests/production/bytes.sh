#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Whether the program makes the same pictures wherever it was built and runs. Every example is rendered small, and the
# SHA-256 of each file is printed; with the list of another build or machine, those that differ are named instead. It takes
# half a minute.
#   bytes.sh PROGRAM > LIST     on one machine
#   bytes.sh PROGRAM LIST       on another; ends with 1 if a picture differs
# GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-FMA_Usable,-AVX2_Usable before it makes the machine an older one for the
# C library.
set -euo pipefail
[ $# -eq 1 ] || [ $# -eq 2 ] || { sed -n '3,9s/^# //p' "$0"; exit 2; }

program=$(realpath "$1")
list=${2:+$(realpath "$2")}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$(dirname "$0")/../.."

find examples -name '*.pov' | sort | while read -r scene; do
    # Sixteen bits for each number, so that small differences are seen.
    "$program" "$scene" +W64 +H48 +FN16 -A --samples 2 --seed 3 +WT1 "+O$folder/made.png" > "$folder/said" 2>&1 ||
        { cat "$folder/said" >&2; echo "$scene does not render" >&2; exit 1; }
    echo "$(sha256sum < "$folder/made.png" | cut -d' ' -f1) $scene"
done > "$folder/list"

[ -n "$list" ] || { cat "$folder/list"; exit 0; }
if cmp -s "$list" "$folder/list"; then
    echo "all $(wc -l < "$list") pictures are the same"
else
    echo "pictures that differ, or that only one of both has:"
    sort "$list" "$folder/list" | uniq -u | cut -d' ' -f2 | sort -u
    exit 1
fi
