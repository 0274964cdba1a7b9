#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The preview's page in a browser without a window: the picture's size and a slider are there, the report of light, what
# is under a pixel, and after a mistake in the scene its message; a page of another site turns no slider and shows
# nothing of it. Ends with 77 where chromium is missing. With a folder,
# it leaves pictures of the page there.
#   preview_page.sh PROGRAM [FOLDER]
set -euo pipefail

command -v chromium > /dev/null || { echo "skipped: chromium is not installed"; exit 77; }
program=$(realpath "$1")
shots=${2:+$(realpath "$2")}
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
plane { y, -2 pigment { checker rgb 1, rgb <0.3, 0.5, 0.8> } }
light_source { <-5, 8, -6>, rgb 0.6 }
SCENE
"$program" scene.pov +W320 +H240 --samples 64 --preview 0 2> log &
preview=$!
for _ in $(seq 300); do grep -q http log && break; sleep 0.1; done
address=$(sed -n 's/^preview: //p' log)

browse() {
    timeout 60 chromium --headless --no-sandbox --disable-gpu "--user-data-dir=$folder/profile" \
        --virtual-time-budget=4000 "$@" 2> /dev/null || true
}

# What the page says, with something behind its address, tried until it says what is wanted.
expect() {
    for _ in $(seq 20); do
        browse --dump-dom "$address${2:-}" > page
        if grep -q -- "$1" page; then
            [ -z "$shots" ] || browse --window-size=900,600 "--screenshot=$shots/${3:-page}.png" "$address${2:-}"
            return
        fi
    done
    echo "the page never says $1"
    exit 1
}
expect '<span id="status">[^<]*320 x 240' '' picture
expect '<label title="of the lamp">Size '
expect '<pre id="lights"[^>]*>.*light ' '#lights&view=normal' lights
expect 'scene.pov:5: light_source' '#lights'
expect 'object 2: scene.pov:4: plane' '#pick=160,230' pixel
grep -q 'pigment { checker' page
grep -q '%  scene.pov:3: sphere' page
grep -q '%  scene.pov:5: light_source' page

# A page from elsewhere, on which each way to ask has ended after a moment.
cat > elsewhere.html << PAGE
<body><script>
const tell = (name, result) => document.body.append(name + ":" + result + " ");
for (const [name, options] of Object.entries({
    get: {}, blind: { mode: "no-cors" }, post: { method: "POST", mode: "no-cors", body: "name=Size&value=2" } }))
  fetch("${address}turn?name=Size&value=2", options).then(() => tell(name, "sent"), () => tell(name, "refused"));
for (const [name, path] of Object.entries({ picture: "picture.png", turn: "turn?name=Size&value=2" })) {
  const image = new Image();
  image.onload = () => tell(name, "loaded");
  image.onerror = () => tell(name, "refused");
  image.src = "$address" + path;
}
</script></body>
PAGE
browse --dump-dom "file://$folder/elsewhere.html" > page
for refused in get picture turn; do
    grep -q "$refused:refused" page || { echo "another site is not refused: $refused"; exit 1; }
done
expect '<output>1</output>'

echo 'sphere { 0, Sise }' >> scene.pov
expect 'nothing is declared as `Sise`' '' mistake
