#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Ends the program at random moments, by signals that it sees and by one that nobody sees (KILL), goes on with +C,
# and compares the picture with that of a run that nothing disturbed.
#   kill_and_resume.sh PROGRAM [KILLS]
set -euo pipefail

program=$(realpath "$1")
kills=${2:-100}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > scene.pov <<'SCENE'
#version 3.7;
camera { location <0, 2, -6> look_at <0, 0.8, 0> }
plane { y, 0 pigment { checker rgb 0.9, rgb 0.4 } }
sphere { <0, 1, 0>, 1 pigment { rgb <0.9, 0.5, 0.4> } finish { reflection 0.2 } }
#for (I, 0, 11)
    sphere { <2, 0.4, 0>, 0.1 rotate 30*I*y pigment { rgb 1 } finish { diffuse 0 emission 9 } }
#end
SCENE
signals=(KILL TERM INT)
done_kills=0 pictures=0
while [ "$done_kills" -lt "$kills" ]; do
    pictures=$((pictures + 1))
    way=(+W160 +H120 --seed "$pictures")
    [ $((pictures % 2)) -eq 0 ] || way+=(--samples 24)
    "$program" scene.pov -V "${way[@]}" +Owhole.png
    here=0
    while true; do
        "$program" scene.pov -V "${way[@]}" "+WT$((RANDOM % 3 + 1))" --checkpoint 0.05s +Obroken.png +C &
        child=$!
        sleep "0.$(printf %03d $((RANDOM % 700)))"
        if kill "-${signals[RANDOM % 3]}" "$child" 2> /dev/null; then done_kills=$((done_kills + 1)) here=$((here + 1)); fi
        status=0
        wait "$child" 2> /dev/null || status=$?
        case $status in
            0) break ;;
            4 | 130 | 137 | 143) ;;  # stopped with its state; or ended by the signal, before or after
            *) echo "exit status $status after $done_kills signals"; exit 1 ;;
        esac
        # A picture is ended so often; the rest is made without signals.
        if [ "$here" -ge 10 ] || [ "$done_kills" -ge "$kills" ]; then
            "$program" scene.pov -V "${way[@]}" +Obroken.png +C
            break
        fi
    done
    cmp whole.png broken.png
    [ ! -e broken.png.state.exr ] || { echo "a state is left of a finished picture"; exit 1; }
    rm broken.png
done
echo "$done_kills signals over $pictures pictures: all the same as undisturbed ones"
