#!/usr/bin/env bash
# SPDX-License-Identifier: CC0-1.0
# The same with GNU parallel, on this machine or on others (PARALLEL='--sshlogin a,b' with a shared folder).
#   parallel.sh 8 scene.pov out/scene.png +W1920 +H1080 --samples 256
set -euo pipefail

shards=$1 scene=$2 picture=$3
shift 3
candelabra=${CANDELABRA:-candelabra}
seq "$shards" | parallel -q --halt now,fail=1 "$candelabra" "$scene" "$@" "+O$picture" --shard "{}/$shards" +C -V
"$candelabra" merge "+O$picture" "$picture".*of"$shards".state.exr
