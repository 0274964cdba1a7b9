#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What can go wrong around a rendering: each has a message, and nothing that was written before is lost.
#   never_lost.sh PROGRAM
set -uo pipefail

program=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
echo '#version 3.7; #include "part.inc" sphere { <0, 0, 5>, 2 pigment { rgb 1 } finish { emission 0.5 } }' > scene.pov
echo 'camera { location 0 } sphere { <3, 3, 4>, 1 pigment { rgb 1 } finish { emission 5 } }' > part.inc
failures=0

# expect NAME STATUS TEXT COMMAND...: the command ends so, and says so.
expect() {
    local name=$1 status=$2 text=$3 got=0
    shift 3
    "$@" > out.txt 2>&1 || got=$?
    if [ "$got" -eq "$status" ] && grep -qF -- "$text" out.txt; then
        echo "ok: $name"
    else
        echo "FAILED: $name (status $got instead of $status)"
        cat out.txt
        failures=$((failures + 1))
    fi
}
check() {
    local name=$1
    shift
    if "$@"; then echo "ok: $name"; else echo "FAILED: $name"; failures=$((failures + 1)); fi
}
render() { "$program" scene.pov +W64 +H48 --samples 4 "$@"; }
begin() { "$program" scene.pov +W64 +H48 -V "$@" & child=$!; }

expect "a full device" 3 "No space left on device" render -V +O/dev/full +FN
echo precious > old.png
full() { (ulimit -f 1; render -V +Oold.png +W300 +H300); }
expect "a file that grows too large" 3 "cannot write" full
check "the old picture is as it was" grep -qx precious old.png
expect "layers for which there is no room" 3 "cannot write" bash -c "ulimit -f 60; '$program' scene.pov -V +Olayers.png +W300 +H200 --layers all --samples 1"
check "the picture beside them is whole" "$program" scene.pov -V +Oagain.png +W300 +H200 --samples 1
# The same where light is denoised, or developed later.
render -V +Olight.exr +W300 +H300 --denoise
develop() { "$program" develop light.exr "$@"; }
expect "a full device for what is developed" 3 "No space left on device" develop -o /dev/full +FN
full_developed() { (ulimit -f 1; develop -o old.png); }
expect "what is developed grows too large" 3 "cannot write" full_developed
full_denoised() { (ulimit -f 1; render -V --denoise +Oold.png +W300 +H300); }
expect "what is denoised grows too large" 3 "cannot write" full_denoised
for size in 0 1 100 5000; do
    head -c $size light.exr > short.exr
    expect "a light of $size bytes" 3 "cannot read" "$program" develop short.exr -o old.png
done
check "the old picture is as it was even then" grep -qx precious old.png
check "no draft is left" test -z "$(find . -name '.candelabra*')"
# Known before the work, not after it.
cp "$program" alone
expect "no library for the format" 3 "the library of picture formats" \
       timeout 60 ./alone scene.pov -V +Oalone.bmp +W9000 +H9000 --samples 1000
expect "no such folder" 3 "there is no folder" render -V +Onowhere/a.png
mkdir -m 555 closed
as_other=()
if [ "$(id -u)" -eq 0 ]; then  # who may do everything
    chmod 755 .
    as_other=(setpriv --reuid=65534 --clear-groups)
fi
if "${as_other[@]}" test -x "$program"; then
    expect "a folder without permission" 3 "Permission denied" \
           "${as_other[@]}" "$program" scene.pov -V +W64 +H48 +Oclosed/a.png
else
    echo "left out: a folder without permission (others cannot run $program)"
fi

# A file that changes while the picture is made does not matter to it, but a state remembers.
render -V +Oundisturbed.png --samples 300
begin +Oa.png --samples 300
sleep 0.2
cp part.inc part.old
echo '// another scene' >> part.inc
wait $child
check "a scene that changes meanwhile" cmp -s undisturbed.png a.png
cp part.old part.inc
begin +Ob.png --samples 30000 --checkpoint 0.1s
for _ in $(seq 600); do  # its state says that it listens to signals
    [ ! -e b.png.state.exr ] || break
    sleep 0.1
done
kill -TERM $child
wait $child
status=$?
check "a stop is told from an end" test $status -eq 4
echo '// another scene' >> part.inc
expect "a changed scene is not continued" 3 '`part.inc` has changed' render +Ob.png --samples 30000 +C
cp part.old part.inc
cp b.png.state.exr state
for size in 0 1 100 5000; do
    head -c $size state > b.png.state.exr
    expect "a state of $size bytes" 3 "cannot read" render +Ob.png --samples 30000 +C
done

begin +Oc.png --samples 100000
sleep 0.5
expect "a second run with the same output" 3 "another run is making" render -V +Oc.png
kill -TERM $child
wait $child
# A second frame at the same time needs as much again.
echo 'camera { location -9*z look_at 0 } #for (I, 1, 200000) sphere { <mod(I, 7), mod(I, 11), I/1e4>, 0.1 } #end' > many.pov
ahead() { grep -o '"prepared_ahead": [a-z]*' "$1" | cut -d' ' -f2; }
for memory in 60M 4G; do
    "$program" many.pov -V +W64 +H48 --samples 4 +KFF3 +WT2 +Om$memory.png --memory $memory --stats m$memory.json || failures=$((failures + 1))
done
check "no frame is prepared ahead where memory is short" test "$(ahead m60M3.json)" = false
check "frames are prepared ahead where there is memory" test "$(ahead m4G3.json)" = true
for frame in 1 2 3; do check "frame $frame is the same" cmp -s m60M$frame.png m4G$frame.png; done
expect "a memory limit" 3 "MB of memory for this scene, and the limit is 300 MB" render -V +Od.png +W20000 +H20000 --memory 300M
exit $((failures > 0))
