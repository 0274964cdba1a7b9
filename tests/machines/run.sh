#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Scenes by programs that find different instructions, and with a C library that finds fewer of them: the pictures must be
# the same to the last bit.
#   run.sh PROGRAM OTHER...
set -euo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat > "$folder/scene.pov" << 'END'
#version 3.7;
// Leaves of spheres and triangles, noise, and as many lights as the octree needs.
camera { location <0, 5, -9> look_at <0, 0.5, 0> angle 50 }
plane { y, 0 pigment { granite scale 2 } normal { bumps 0.2 } }
#declare R = seed(1);
#for (I, 1, 300)
  sphere {
    <rand(R), 0.3 * rand(R), rand(R)> * 6 - <3, 0, 3>, 0.05 + 0.1 * rand(R)
    pigment { bozo scale 0.1 }
    #if (mod(I, 3) = 0) finish { emission 2 } #else finish { reflection 0.2 } #end
  }
#end
mesh {
  #for (I, 1, 400)
    #local P = <rand(R), rand(R), rand(R)> * 4 - <2, 0, 2>;
    triangle { P, P + <rand(R), 0, rand(R)> * 0.4, P + <0, rand(R), rand(R)> * 0.4 }
  #end
  pigment { rgb <0.9, 0.6, 0.3> }
}
light_source { <5, 9, -6>, rgb 0.5 }
END

# The C library chooses its functions by the processor, too.
fewer=GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4,-FMA_Usable,-AVX2_Usable
examples=$(cd "$(dirname "$0")/../../examples" && pwd)
first=$1

# Runs a command silently, unless it fails.
quietly() {
    "$@" > "$folder/said" 2>&1 || { cat "$folder/said"; exit 1; }
}
same() {
    cmp "$folder/$1" "$folder/$2" || { echo "$3"; exit 1; }
}

# A scene and its options.
compare() {
    quietly "$first" "$@" "-o$folder/first.exr"
    quietly env "$fewer" "$first" "$@" "-o$folder/fewer.exr"
    same first.exr fewer.exr "$1: the picture depends on the C library's choice"
    for program in "${programs[@]}"; do
        quietly "$program" "$@" "-o$folder/other.exr"
        same first.exr other.exr "$1: $program makes another picture than $first"
    done
}

programs=("${@:2}")
compare "$folder/scene.pov" +W120 +H90 --samples 4
programs=()
# Photons, media, patterns, splines and many lamps: what computes most with such functions.
for scene in gallery/ballroom gallery/courtyard gallery/campfire lights/lens_in_haze looks/patterns looks/normals; do
    compare "$examples/$scene.pov" +W32 +H24 --samples 1
done

# Shards of unequal machines.
scene=("$examples/gallery/ballroom.pov" +W32 +H24 --samples 2)
quietly "$first" "${scene[@]}" "-o$folder/whole.exr"
quietly "$first" "${scene[@]}" --shard 1/2 "-o$folder/a.exr"
quietly env "$fewer" "$first" "${scene[@]}" --shard 2/2 "-o$folder/b.exr"
quietly "$first" merge "-o$folder/joined.exr" "$folder"/a*.state.exr "$folder"/b*.state.exr
same whole.exr joined.exr "the merged picture differs from that of one run"
