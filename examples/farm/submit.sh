#!/usr/bin/env bash
# SPDX-License-Identifier: CC0-1.0
# Sends a picture, or an animation, to a Slurm cluster.
#   submit.sh 16 scene.pov out/scene.png '+W1920 +H1080 --samples 256'
#   submit.sh 16 scene.pov out/frame.png '+W1920 +H1080 +KFF240' film.mp4
# With a film's name the jobs share the frames, otherwise the samples of the picture.
set -euo pipefail

shards=$1 scene=$2 picture=$3 options=${4:-} film=${5:-}
here=$(cd "$(dirname "$0")" && pwd)
candelabra=${CANDELABRA:-candelabra}
export SCENE=$scene PICTURE=$picture OPTIONS=$options CANDELABRA=$candelabra

array=$(sbatch --parsable --export=ALL --array="1-$shards" "$here/array.slurm")
echo "array: $array"
if [ -z "$film" ]; then
    last="'$candelabra' merge '+O$picture' '$picture'.*.state.exr"
else
    # All frames are there: what is left is the film.
    last="'$candelabra' '$scene' $options '+O$picture' --skip-existing --movie '$film'"
fi
sbatch --parsable --dependency="afterok:$array" --job-name=candelabra-join --wrap="$last"
