#!/usr/bin/env bash
# SPDX-License-Identifier: CC0-1.0
# Renders the eight pictures of the gallery, 1600 by 900 pixels, denoised, as WebP of at most 200 KB:
#
#   examples/gallery/render.sh [FOLDER [SCENE ...]]   into FOLDER, examples/pictures if none is named
#   examples/gallery/render.sh film [FILE]            the LED tree as a film of six seconds, tree.mp4
#
# CANDELABRA names the program, build/candelabra if it is not set. The pictures need oiiotool of the
# package openimageio-tools, the film ffmpeg.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
candelabra=${CANDELABRA:-$here/../../build/candelabra}
most=200000

if [ "${1:-}" = film ]; then
    frames=$(mktemp -d)
    trap 'rm -rf "$frames"' EXIT
    "$candelabra" "$here/christmas_tree.pov" +W640 +H360 --samples 4 --denoise \
        +KFF150 +KC +O"$frames/tree.png" --movie "${2:-tree.mp4}" --progress none
    exit
fi

folder=${1:-$here/../pictures}
mkdir -p "$folder"
[ $# -eq 0 ] || shift
samples() { # SCENE: rays for each pixel, as many as the denoiser needs there
    case $1 in
        night_street) echo 6 ;;
        sphereflakes | metropolis | marquee) echo 5 ;;
        ballroom) echo 8 ;;
        lantern_festival | christmas_tree | neon) echo 4 ;;
        *) echo 3 ;;
    esac
}
[ $# -gt 0 ] || set -- sphereflakes night_street ballroom lantern_festival metropolis \
    christmas_tree marquee neon

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for scene; do
    "$candelabra" "$here/$scene.pov" +W1600 +H900 --samples "$(samples "$scene")" --denoise \
        +O"$work/$scene.png" --progress none
    for quality in 90 85 80 75 70 65 60 50; do
        oiiotool "$work/$scene.denoised.png" --compression "webp:$quality" -o "$folder/$scene.webp"
        [ "$(wc -c <"$folder/$scene.webp")" -gt $most ] || break
    done
done
