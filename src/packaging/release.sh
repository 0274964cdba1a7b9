#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes everything that a release offers for download, with checksums, in OUTPUT (default: release).
#   release.sh [--build BUILD] [--wasm BUILD] [--chroot FOLDER] [--only PHASE,...] [--debian SUITE=FOLDER]... [OUTPUT]
# --build: where the program is, or is built (default: build); --wasm: the same of WebAssembly (default: build-wasm), which is
# built where emscripten is installed, or in the Debian 13 that --chroot makes in FOLDER (wasm/build.sh), as root
# --only: some of the phases deb, tarball, wheel, npm, playground, debian, which are
#   deb         the .deb for the Debian that this is
#   tarball     a tarball for any Linux of this processor
#   wheel       the module of Python, for the Python and the system that this is
#   npm         the npm package, for all systems with node
#   playground  the page that runs the program, as a folder in a .zip and as one file
#   debian      with --debian: the .deb of another Debian, such as trixie=/srv/trixie (tests/production/debian.sh); as root
# What this system cannot make is left out, with its reason; the rest is made. A phase that fails ends the script.
set -euo pipefail

own=$(realpath "$(dirname "$0")")
root=$(realpath "$own/../..")
usage() { sed -n '3,15s/^# //p' "$0" >&2; exit 2; }

build=$root/build wasm=$root/build-wasm output= debians=() chroot=()
phases=deb,tarball,wheel,npm,playground,debian
while [ $# -gt 0 ]; do
    case $1 in
        --build | --wasm | --chroot | --only | --debian) [ $# -ge 2 ] || usage ;;&
        --build) build=$(realpath -m "$2"); shift 2 ;;
        --wasm) wasm=$(realpath -m "$2"); shift 2 ;;
        --chroot) chroot=(--chroot "$2"); shift 2 ;;
        --only) phases=$2; shift 2 ;;
        --debian) [[ $2 = ?*=?* ]] || usage; debians+=("$2"); shift 2 ;;
        -*) usage ;;
        *) [ -z "$output" ] || usage; output=$1; shift ;;
    esac
done
for phase in ${phases//,/ }; do
    case $phase in deb | tarball | wheel | npm | playground | debian) ;; *) usage ;; esac
done
output=$(realpath -m "${output:-$root/release}")
mkdir -p "$output"
version=$(sed -n 's/^project(candelabra VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
made=() begun=$SECONDS

wanted() { [[ ,$phases, = *,$1,* ]]; }
left_out() { echo "left out: $*"; }
phase() { echo "== $1"; }
# Notes files that are made, with their sizes.
note() {
    local file
    for file in "$@"; do
        made+=("$(basename "$file")")
        printf '%-56s %10d bytes\n' "${made[-1]}" "$(stat -c %s "$file")"
    done
}
# The first of some commands that is not there.
missing() {
    local tool
    for tool in "$@"; do command -v "$tool" > /dev/null || { echo "$tool"; return; }; done
}
# Runs a command, whose words are shown only if it fails.
quietly() {
    local log=$output/.log
    "$@" > "$log" 2>&1 || { cat "$log" >&2; echo "release.sh: failed: $*" >&2; exit 1; }
    rm -f "$log"
}

build_program() {
    [ -x "$build/candelabra" ] && return
    phase "the program, in $build"
    quietly cmake -S "$root" -B "$build" -G Ninja -DCANDELABRA_TESTS=OFF
    quietly cmake --build "$build"
}
# The newest version of the C library that a file asks for.
needed_glibc() { objdump -T "$1" | grep -o 'GLIBC_[0-9.]*' | sort -Vu | tail -n 1 | sed 's/_/ /'; }

make_packed() {  # TGZ or DEB
    quietly cmake -E chdir "$build" cpack -G "$1" -B "$output/.packed"
}
make_deb() {
    phase deb
    local lacks
    lacks=$(missing dpkg-deb dpkg-shlibdeps file objdump)
    [ -z "$lacks" ] || { left_out "the .deb; $lacks is not installed"; return; }
    build_program
    make_packed DEB
    mv "$output"/.packed/*.deb "$output/"
    note "$output/candelabra_${version}_"*.deb
    echo "it needs the libraries of this system, and of the C library $(needed_glibc "$build/candelabra") or newer"
}
make_tarball() {
    phase tarball
    local lacks file
    lacks=$(missing dpkg-query ldd)
    [ -z "$lacks" ] || { left_out "the tarball; $lacks is not installed, and its libraries come from Debian"; return; }
    build_program
    make_packed TGZ
    file=$output/candelabra-$version-any-linux-$(uname -m).tar.gz
    quietly "$own/tarball.sh" "$output/.packed/"*.tar.gz "$file"
    note "$file"
    echo "it has a C library of its own, so that the system's may be of any age"
}
make_wheel() {
    phase wheel
    if ! /usr/bin/python3 -c 'import pybind11' 2> /dev/null && ! [ -d /usr/include/pybind11 ]; then
        left_out "the wheel; pybind11 is not installed"
        return
    fi
    build_program
    if ! grep -q '^CANDELABRA_PYTHON:BOOL=ON' "$build/CMakeCache.txt"; then
        left_out "the wheel; $build is without Python (CANDELABRA_PYTHON)"
        return
    fi
    local carry=on
    [ -z "$(missing patchelf)" ] || carry=
    quietly env PYTHONPATH="$own" /usr/bin/python3 -c 'import sys, python_wheel
python_wheel.build_wheel(sys.argv[1], {"build-dir": sys.argv[2], "carry-libraries": sys.argv[3]})' "$output" "$build" "$carry"
    note "$output/candelabra-$version-"*.whl
    [ -n "$carry" ] || echo "it needs the libraries of this system, as patchelf is not installed"
}
# Builds WebAssembly, or takes what was built before; says what is left out if neither can be.
build_wasm() {  # WHAT
    if [ ${#chroot[@]} -gt 0 ] || [ -z "$(missing em++)" ]; then
        quietly "$own/wasm/build.sh" "${chroot[@]}" "$wasm"
    elif [ ! -e "$wasm/candelabra.wasm" ]; then
        left_out "$1; there is no WebAssembly in $wasm, and no emscripten: --chroot FOLDER builds it"
        return 1
    elif [ -n "$(find "$root/src" "$root/stdlib" "$root/grammar" -newer "$wasm/candelabra.wasm" -type f | head -n 1)" ]; then
        echo "candelabra.wasm is older than the sources, and is taken as it is"
    fi
}
make_npm() {
    phase npm
    build_wasm "the npm package" || return 0
    quietly "$own/npm/pack.sh" "$wasm"
    cp "$wasm/candelabra-$version.tgz" "$output/candelabra-$version-npm.tgz"
    note "$output/candelabra-$version-npm.tgz"
}
make_playground() {
    phase playground
    local lacks
    lacks=$(missing node python3)
    [ -z "$lacks" ] || { left_out "the playground; $lacks is not installed"; return; }
    build_wasm "the playground" || return 0
    quietly "$own/npm/pack.sh" "$wasm"
    quietly python3 "$root/src/playground/pack.py" "$wasm"
    rm -f "$output/candelabra-$version-playground.zip"
    quietly python3 -m zipfile -c "$output/candelabra-$version-playground.zip" "$wasm/playground"
    cp "$wasm/playground.html" "$output/candelabra-$version-playground.html"
    note "$output/candelabra-$version-playground."{zip,html}
}
make_debian() {  # SUITE=FOLDER
    local suite=${1%%=*} folder=${1#*=} file
    phase "debian $suite"
    [ "$(id -u)" -eq 0 ] || { left_out "the .deb for $suite; only root can make a system to build it in"; return; }
    [ -z "$(missing debootstrap)" ] || [ -d "$folder/etc" ] ||
        { left_out "the .deb for $suite; debootstrap is not installed"; return; }
    quietly "$root/tests/production/debian.sh" "$suite" "$folder" bash -ec "tests/install_packages.sh
        apt-get install -y -qq --no-install-recommends dpkg-dev file
        cmake -S . -B build-release -G Ninja -DCANDELABRA_TESTS=OFF && cmake --build build-release
        cd build-release && rm -f *.deb && cpack -G DEB"
    for file in "$folder"/candelabra/build-release/candelabra_*.deb; do
        cp "$file" "$output/$(basename "$file" .deb)_$suite.deb"
        note "$output/$(basename "$file" .deb)_$suite.deb"
    done
}

rm -rf "$output/.packed"
! wanted deb || make_deb
! wanted tarball || make_tarball
! wanted wheel || make_wheel
! wanted npm || make_npm
! wanted playground || make_playground
if wanted debian; then
    for each in "${debians[@]}"; do make_debian "$each"; done
fi
rm -rf "$output/.packed"
[ ${#made[@]} -gt 0 ] || { echo "release.sh: nothing could be made" >&2; exit 1; }
(cd "$output" && sha256sum "${made[@]}" > SHA256SUMS)
echo "== $output/SHA256SUMS: ${#made[@]} files, in $((SECONDS - begun)) s"
