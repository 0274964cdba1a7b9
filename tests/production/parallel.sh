#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# GNU parallel runs three shards by the script in examples/farm; the picture must be that of a single run. Ends with 77
# where it is missing.
#   parallel.sh PROGRAM
set -euo pipefail

parallel --version 2> /dev/null | grep -q GNU || { echo "skipped: GNU parallel is not installed"; exit 77; }
program=$(realpath "$1")
examples=$(realpath "$(dirname "$0")/../../examples")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

options=(+W60 +H40 --samples 6)
"$program" "$examples/lights/ring.pov" "+O$folder/whole.png" "${options[@]}" -V
CANDELABRA=$program HOME=$folder "$examples/farm/parallel.sh" 3 "$examples/lights/ring.pov" "$folder/shared.png" "${options[@]}"
cmp whole.png shared.png
