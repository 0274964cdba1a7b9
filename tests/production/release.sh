#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The downloads of src/packaging/release.sh, made and tried: the tarball renders from any folder with nothing in its
# environment, also through a link to the program, and in a system that has no library at all; the .deb has what a package
# needs; what cannot be made is left out with the reason. Ends with 77 where Debian's tools are missing.
#   release.sh BUILD-FOLDER
set -euo pipefail

for tool in dpkg-deb dpkg-shlibdeps file; do
    command -v "$tool" > /dev/null || { echo "skipped: $tool is not installed"; exit 77; }
done
build=$(realpath "$1")
root=$(realpath "$(dirname "$0")/../..")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

release=$(realpath "$(dirname "$0")/../../src/packaging/release.sh")
version=$("$build/candelabra" --version | cut -d ' ' -f 2)
wasm=(npm)
[ -z "$(command -v em++)" ] || wasm=()  # it would be built
"$release" --build "$build" \
    --wasm "$folder/no wasm" --only "deb,tarball,wheel${wasm[*]:+,npm}" "$folder/made" > "$folder/said" 2>&1 < /dev/null ||
    { cat "$folder/said"; exit 1; }
for line in ${wasm[*]:+'left out: the npm package; there is no WebAssembly'} 'of the C library GLIBC [0-9.]* or newer' \
    'it has a C library of its own'; do
    grep -q "$line" "$folder/said" || { echo "FAILED: release.sh does not say: $line"; cat "$folder/said"; exit 1; }
done
(cd "$folder/made" && sha256sum --quiet -c SHA256SUMS)
[ "$(wc -l < "$folder/made/SHA256SUMS")" -eq "$(find "$folder/made" -name 'candelabra*' | wc -l)" ]
! "$release" --only nonsense "$folder/made" 2> /dev/null
echo "ok: what release.sh makes, says and leaves out"

mkdir "$folder/some where" "$folder/scenes"
tar xf "$folder/made/candelabra-$version-any-linux-"*.tar.gz -C "$folder/some where" --strip-components=1
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
env -i ./link a.pov +W80 +H60 +Olink.exr
# OpenImageIO with all that it needs is twenty times as large as the rest.
! env -i ./link a.pov +W80 +H60 +Olink.bmp 2> bmp.said
grep -q 'the library of picture formats cannot be opened' bmp.said || { cat bmp.said; exit 1; }
"$build/candelabra" a.pov +W80 +H60 +Obuild.png
cmp tar.png build.png
[ -s link.exr ] && [ ! -e link.bmp ]
env -i "$folder/some where/bin/candelabra-povray" a.pov +W80 +H60 +Opovray.png
[ -s povray.png ]
echo 'camera { location -5*z look_at 0 } mesh { difference { box { -1, 1 } box { 0, 2 } } pigment { rgb 1 } }
      light_source { <5, 5, -5>, rgb 1 }' > b.pov
env -i "$program" b.pov +W40 +H30
echo "ok: the tarball from another folder"
# A system with nothing in it but the tarball and a scene.
if unshare --user --map-root-user --mount --pid --fork true 2> /dev/null; then
    mkdir -p "$folder/empty/proc" "$folder/empty/tmp"
    cp -r "$folder/some where" "$folder/empty/candelabra"
    cp a.pov "$folder/empty/tmp"
    env -i unshare --user --map-root-user --mount --pid --fork /bin/sh -c '/bin/mount -t proc proc "$0/proc" &&
        exec /usr/sbin/chroot "$0" /candelabra/libexec/loader --library-path /candelabra/lib/candelabra \
            /candelabra/libexec/candelabra /tmp/a.pov +W80 +H60 +O/tmp/a.png' "$folder/empty" 2> "$folder/said" ||
        { cat "$folder/said"; exit 1; }
    cmp "$folder/empty/tmp/a.png" build.png
    echo "ok: the tarball in an empty system"
else
    echo "left out: the tarball in an empty system (it cannot be made here)"
fi
for part in share/man/man1/candelabra.1 share/man/man1/candelabra-povray.1 share/man/man7/candelabra-tutorial.7 \
    share/candelabra/vscode/package.json \
    share/candelabra/candelabra-"$version".vsix share/candelabra/stdlib/colors.inc share/candelabra/examples/paper/fig6.pov \
    share/metainfo/candelabra.metainfo.xml share/applications/candelabra.desktop share/doc/candelabra/copyright \
    share/doc/candelabra/libraries/README share/doc/candelabra/libraries/libc6; do
    [ -s "$folder/some where/$part" ] || { echo "FAILED: no $part in the tarball"; exit 1; }
done
echo "ok: what the tarball has"

deb=$(echo "$folder/made/candelabra_${version}"_*.deb)
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
wheel=$(echo "$folder/made/candelabra-$version"-*.whl)
if [ -e "$wheel" ] && /usr/bin/python3 -c 'import numpy' 2> /dev/null; then
    mkdir "$folder/wheel"
    /usr/bin/python3 -m zipfile -e "$wheel" "$folder/wheel"
    env -i PYTHONPATH="$folder/wheel" /usr/bin/python3 -c 'import candelabra
candelabra.render("a.pov", width=80, height=60).save("wheel.png")'
    cmp wheel.png build.png
    echo "ok: the wheel"
    # One that carries its libraries needs none of the system but those of C and C++.
    if command -v patchelf > /dev/null; then
        for file in "$folder"/wheel/candelabra/*.so*; do env -i ldd "$file"; done |
            grep '=> /' | grep -vE "=> $folder/|/(lib(c|m|stdc\+\+|gcc_s)|ld-linux[^ ]*)\.so" && { echo "FAILED: a library is not carried"; exit 1; }
        [ -s "$(find "$folder/wheel/candelabra/licences" -name 'libtbb*')" ]
        echo "ok: it carries its libraries"
    fi
fi
ls -l "$folder"/made/candelabra* | awk '{ print $5, $NF }'
