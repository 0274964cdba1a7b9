#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The preview's page in a browser without a window: the picture's size and a slider are there, and after a mistake in
# the scene its message. Ends with 77 where chromium is missing.
#   preview_page.sh PROGRAM
set -euo pipefail

command -v chromium > /dev/null || { echo "skipped: chromium is not installed"; exit 77; }
program=$(realpath "$1")
folder=$(mktemp -d)
preview=
finish() {
    [ -n "$preview" ] && kill "$preview" 2> /dev/null
    wait
    rm -rf "$folder"
}
trap finish EXIT
cd "$folder"

cat > scene.pov << 'SCENE'
#ifndef (Size) #declare Size = 1; #end  // 0.5 to 2: of the lamp
camera { location -5*z look_at 0 }
sphere { 0, Size pigment { rgb 1 } finish { emission 1 } }
SCENE
"$program" scene.pov +W64 +H48 --preview 0 2> log &
preview=$!
for _ in $(seq 300); do grep -q http log && break; sleep 0.1; done
address=$(sed -n 's/^preview: //p' log)

# What the page says, tried until it says what is wanted.
expect() {
    for _ in $(seq 20); do
        timeout 60 chromium --headless --no-sandbox --disable-gpu "--user-data-dir=$folder/profile" \
            --virtual-time-budget=3000 --dump-dom "$address" 2> /dev/null > page || true
        grep -q "$1" page && return
    done
    echo "the page never says $1"
    exit 1
}
expect '<span id="status">[^<]*64 x 48'
expect '<label title="of the lamp">Size '
echo 'sphere { 0, Sise }' >> scene.pov
expect 'nothing is declared as `Sise`'
