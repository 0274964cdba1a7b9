#!/usr/bin/env bash
# SPDX-License-Identifier: CC0-1.0
# Contact sheets of pigments, normals, finishes, lights and cameras: a tile for each example that the
# program has of the word, with the example below it. sheets.sh [program] [folder] [word ...]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "${1:-$here/../../build/candelabra}")
folder=$(realpath "${2:-.}")
shift $(($# < 2 ? $# : 2))
kinds=("${@:-}")
[ -n "${kinds[0]}" ] || kinds=(pigment normal finish light_source camera)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
width=160 height=120 columns=6 lettering=31  # of a tile, of a sheet, below a tile

head='#version 3.7; global_settings { assumed_gamma 1 }'
eye='camera { location -4*z look_at 0 angle 40 right 4/3*x }'
lamp='light_source { <-4, 6, -8>, rgb 1 }'
sky='background { rgb <0.3, 0.35, 0.4> }'
floor='plane { y, 0 pigment { checker rgb 0.9, rgb 0.35 } finish { ambient 0.1 diffuse 0.7 } }'

# The scene of one tile.
scene() {
    case $1 in
        pigment) echo "$head $eye box { <-1.9, -1.4, -0.01>, <1.9, 1.4, 1>
            texture { $2 finish { ambient 1 diffuse 0 } } }" ;;
        normal) echo "$head $eye $lamp $sky sphere { 0, 1.1 pigment { rgb <0.9, 0.75, 0.5> }
            $2 finish { specular 0.3 roughness 0.02 } }" ;;
        finish) echo "$head global_settings { subsurface { } } $eye $lamp sky_sphere { pigment { gradient y
            color_map { [0 rgb <0.9, 0.9, 0.8>] [1 rgb <0.3, 0.5, 0.9>] } } }
            object { $floor translate -y } sphere { 0, 1
            pigment { rgb <0.9, 0.55, 0.25> } $2 }" ;;
        light_source) echo "$head camera { location <0, 3, -6> look_at 0.5*y angle 45 right 4/3*x }
            $floor sphere { <-0.7, 0.7, 0>, 0.7 pigment { rgb <0.9, 0.5, 0.3> } }
            cylinder { <1, 0, 0.4>, <1, 1.8, 0.4>, 0.3 pigment { rgb <0.4, 0.6, 0.9> } }
            $2" ;;
        camera) echo "$head $2 $lamp $sky $floor
            sphere { 0.7*y, 0.7 pigment { rgb <0.9, 0.5, 0.3> } }
            #for (I, 0, 11) cylinder { 0, 3*y, 0.25 pigment { rgb <0.4, 0.6, 0.9> }
                translate 4*z rotate 30*I*y } #end" ;;
    esac
}

sheet() {
    local kind=$1 n=0 rows line words
    : >"$work/tiles.inc"
    while IFS= read -r line; do
        scene "$kind" "$line" >"$work/tile.pov"
        "$program" "$work/tile.pov" +W$width +H$height +A0.3 +R2 -V "+O$work/$kind$n.png"
        mapfile -t words < <(fold -s -w 36 <<<"$line")
        printf 'Tile(%d, "%s", "%s", "%s", "%s")\n' $n "$kind$n.png" "${words[0]}" "${words[1]:-}" \
            "${words[2]:-}" >>"$work/tiles.inc"
        n=$((n + 1))
    done < <("$program" describe examples | grep "^$kind ")
    rows=$(((n + columns - 1) / columns))
    cat >"$work/$kind.pov" <<EOF
$head
#declare Wide = $((width + 6)); #declare High = $((height + lettering)); #declare Columns = $columns;
camera { orthographic location <Columns*Wide, -$rows*High, -9>/2 right Columns*Wide*x up $rows*High*y }
background { rgb 1 }
#macro Line(Words, Row)
    #if (strlen(Words) > 0)
        text { internal 1 Words, 0.1, 0 scale 9.5 translate <0, -$height - 8 - 9*Row, -1>
            pigment { rgb 0 } finish { ambient 0 diffuse 0 } }
    #end
#end
#macro Tile(N, File, First, Second, Third)
    union {
        box { <0, -1, 0>, <1, 0, 0.1> scale <$width, $height, 1>
            pigment { image_map { png File } translate -y scale <$width, $height, 1> }
            finish { ambient 1 diffuse 0 } }
        Line(First, 0) Line(Second, 1) Line(Third, 2)
        translate <mod(N, Columns)*Wide + 3, -div(N, Columns)*High, 0>
    }
#end
#include "tiles.inc"
EOF
    (cd "$work" && "$program" "$kind.pov" +W$((columns * (width + 6))) \
        +H$((rows * (height + lettering))) +A0.1 -V "+O$kind.png")
    mv "$work/$kind.png" "$folder/sheet_$kind.png"
    echo "$folder/sheet_$kind.png: $n tiles"
}

for kind in "${kinds[@]}"; do sheet "$kind"; done
