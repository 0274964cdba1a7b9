#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# One scene by programs that find different instructions: the pictures must be the same to the last bit.
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

count=0
for program in "$@"; do
    count=$((count + 1))
    "$program" "$folder/scene.pov" +W120 +H90 --samples 4 "-o$folder/$count.exr" > "$folder/said" 2>&1 || {
        cat "$folder/said"
        exit 1
    }
    cmp "$folder/1.exr" "$folder/$count.exr" || {
        echo "$program makes another picture than $1"
        exit 1
    }
done
