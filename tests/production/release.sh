#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The packages of a release, made and tried: the tarball renders from any folder with nothing in its environment, also
# through a link to the program, and the .deb has what a package needs. Ends with 77 where Debian's tools are missing.
#   release.sh BUILD-FOLDER
set -euo pipefail

for tool in dpkg-deb dpkg-shlibdeps file; do
    command -v "$tool" > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
build=$(realpath "$1")
root=$(realpath "$(dirname "$0")/../..")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

(cd "$build" && cpack > "$folder/cpack.log") || { cat "$folder/cpack.log"; exit 1; }
version=$("$build/candelabra" --version | cut -d ' ' -f 2)

mkdir "$folder/some where" "$folder/scenes"
tar xf "$build"/candelabra-"$version"-linux-*.tar.gz -C "$folder/some where" --strip-components=1
program="$folder/some where/bin/candelabra"
cat > "$folder/scenes/a.pov" << 'SCENE'
#include "colors.inc"
#include "light_arrays.inc"
camera { location <0, 2, -6> look_at 0 }
plane { y, -1 pigment { Red } }
object { Light_Ring(sphere { 0, 0.1 pigment { rgb 1 } finish { emission 20 } }, 10, 2) }
intersection { box { -1, 1 } sphere { 0, 1.2 } pigment { White } }
SCENE
cd "$folder/scenes"
env -i "$program" a.pov +W80 +H60 +Otar.png
ln -s "$program" link
env -i ./link a.pov +W80 +H60 +Olink.tga
"$build/candelabra" a.pov +W80 +H60 +Obuild.png
cmp tar.png build.png
[ -s link.tga ]
env -i "$folder/some where/bin/candelabra-povray" a.pov +W80 +H60 +Opovray.png
[ -s povray.png ]
echo 'camera { location -5*z look_at 0 } mesh { difference { box { -1, 1 } box { 0, 2 } } pigment { rgb 1 } }
      light_source { <5, 5, -5>, rgb 1 }' > b.pov
env -i "$program" b.pov +W40 +H30
echo "ok: the tarball from another folder"
for part in share/man/man1/candelabra.1 share/man/man1/candelabra-povray.1 share/man/man7/candelabra-tutorial.7 share/candelabra/vscode/package.json \
    share/candelabra/candelabra-"$version".vsix share/candelabra/stdlib/colors.inc share/candelabra/examples/paper/fig6.pov \
    share/metainfo/candelabra.metainfo.xml share/applications/candelabra.desktop share/doc/candelabra/copyright; do
    [ -s "$folder/some where/$part" ] || { echo "FAILED: no $part in the tarball"; exit 1; }
done
echo "ok: what the tarball has"

deb=$(echo "$build"/candelabra_"$version"_*.deb)
for field in Package=candelabra Version="$version" Section=graphics; do
    [ "$(dpkg-deb --field "$deb" "${field%%=*}")" = "${field#*=}" ] || { echo "FAILED: $field"; exit 1; }
done
dpkg-deb --field "$deb" Depends | grep -q 'libtbb12.*' || { echo "FAILED: the libraries are not named"; exit 1; }
dpkg-deb --contents "$deb" > "$folder/contents"
for part in ./usr/bin/candelabra ./usr/bin/candelabra-povray ./usr/share/candelabra/stdlib/colors.inc ./usr/share/man/man1/candelabra.1 \
    ./usr/share/doc/candelabra/copyright ./usr/share/metainfo/candelabra.metainfo.xml; do
    grep -qF " $part" "$folder/contents" || { echo "FAILED: no $part in the .deb"; exit 1; }
done
dpkg-deb --extract "$deb" "$folder/root"
env -i "$folder/root/usr/bin/candelabra" a.pov +W80 +H60 +Odeb.png
cmp deb.png build.png
echo "ok: the .deb"
if [ -d "$folder/root/usr/lib/python3/dist-packages/candelabra" ] && /usr/bin/python3 -c 'import numpy' 2> /dev/null; then
    env -i PYTHONPATH="$folder/root/usr/lib/python3/dist-packages" /usr/bin/python3 -c 'import candelabra
candelabra.render("a.pov", width=80, height=60).save("python.png")
candelabra.render("a.pov", width=80, height=60).save("python.tga")'
    cmp python.png build.png
    echo "ok: the module of Python in the .deb"
fi
# A wheel that carries its libraries needs none of the system but those of C and C++.
if command -v patchelf > /dev/null && /usr/bin/python3 -c 'import numpy' 2> /dev/null && [ -d "$build/python" ]; then
    mkdir "$folder/wheel" "$folder/carried"
    PYTHONPATH=$root/src/packaging /usr/bin/python3 -c 'import python_wheel, sys
python_wheel.build_wheel(sys.argv[1], {"build-dir": sys.argv[2], "carry-libraries": "on"})' "$folder/wheel" "$build" \
        > "$folder/wheel.log"
    /usr/bin/python3 -m zipfile -e "$folder"/wheel/*.whl "$folder/carried"
    for file in "$folder"/carried/candelabra/*.so*; do env -i ldd "$file"; done |
        grep '=> /' | grep -vE "=> $folder/|/(lib(c|m|stdc\+\+|gcc_s)|ld-linux[^ ]*)\.so" && { echo "FAILED: a library is not carried"; exit 1; }
    [ -s "$(find "$folder/carried/candelabra/licences" -name 'libtbb*')" ]
    env -i PYTHONPATH="$folder/carried" /usr/bin/python3 -c 'import candelabra
candelabra.render("a.pov", width=80, height=60).save("carried.png")'
    cmp carried.png build.png
    echo "ok: a wheel that carries its libraries"
    ls -l "$folder"/wheel/*.whl | awk '{ print $5, $NF }'
else
    echo "left out: the wheel with its libraries (patchelf or numpy is not installed)"
fi
ls -l "$deb" "$build"/candelabra-"$version"-linux-*.tar.gz | awk '{ print $5, $NF }'
