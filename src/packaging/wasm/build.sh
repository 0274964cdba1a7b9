#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the program as WebAssembly: BUILD/candelabra.mjs and BUILD/candelabra.wasm (default of BUILD: build-wasm).
#   build.sh [--chroot FOLDER] [BUILD]
#   build.sh --packages        prints the packages of Debian 13 that it needs
# It takes the emscripten of Debian 13, and the sources of zlib, libpng, libjpeg-turbo, FreeType and Nettle from Debian's
# source packages. On another system it works in a Debian 13 in FOLDER (default: that of the time before, or BUILD/debian),
# which debootstrap makes when it is not there; for that it has to be root. NICE=10 before the command leaves more of the
# machine to others.
set -euo pipefail

root=$(realpath "$(dirname "$0")/../../..")
packages=(emscripten nodejs ccache cmake ninja-build bison re2c nlohmann-json3-dev libglm-dev libboost-dev dpkg-dev
          ca-certificates)
chroot=
while [ $# -gt 0 ]; do
    case $1 in
        --chroot) chroot=${2:?--chroot needs a folder}; shift 2 ;;
        --packages) echo "${packages[*]}"; exit ;;
        -*) sed -n '3,10s/^# //p' "$0"; exit 2 ;;
        *) break ;;
    esac
done
build=${1:-$root/build-wasm}
mkdir -p "$build"
build=$(realpath "$build")

# Whether this system has an emscripten whose standard library suffices: 3.1.69 or later.
has_compiler() {
    command -v em++ > /dev/null || return 1
    local version
    version=$(em++ --version | sed -n '1s/.* \([0-9.]*[0-9]\).*/\1/p')
    [ "$(printf '%s\n' 3.1.69 "$version" | sort -V | head -n 1)" = 3.1.69 ]
}

# Makes a Debian 13 in the folder, with the packages; does nothing if it is complete.
make_chroot() {
    if [ ! -x "$chroot/usr/bin/apt-get" ]; then
        command -v debootstrap > /dev/null || { echo "build.sh: needs debootstrap, or Debian 13" >&2; exit 1; }
        debootstrap --variant=minbase trixie "$chroot" http://deb.debian.org/debian
    fi
    chroot "$chroot" dpkg-query -W "${packages[@]}" > /dev/null 2>&1 && [ -s "$chroot/etc/apt/sources.list" ] &&
        grep -q deb-src "$chroot/etc/apt/sources.list" && return
    printf '%s http://deb.debian.org/debian trixie main\n' deb deb-src > "$chroot/etc/apt/sources.list"
    in_chroot apt-get update -qq
    in_chroot env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${packages[@]}"
}

# Runs a command in the chroot, which sees the sources and the build folder where they are. The mounts end with it.
in_chroot() {
    unshare --mount bash -c '
        chroot=$1 root=$2 build=$3
        mkdir -p "$chroot/proc" "$chroot$root" "$chroot$build"
        mount -t proc proc "$chroot/proc"
        mount --bind "$root" "$chroot$root"
        mkdir -p "$chroot$build"
        mount --bind "$build" "$chroot$build"
        exec chroot "$chroot" "${@:4}"' _ "$chroot" "$root" "$build" "$@"
}

if ! has_compiler; then
    chroot=$(realpath -m "${chroot:-$(cat "$build/chroot" 2> /dev/null || echo "$build/debian")}")
    [ "$(id -u)" -eq 0 ] || { echo "build.sh: a Debian 13 to build in can only be made as root" >&2; exit 1; }
    make_chroot
    echo "$chroot" > "$build/chroot"
    in_chroot env NICE="${NICE:-0}" "$root/src/packaging/wasm/build.sh" "$build"
    exit
fi

renice -n "${NICE:-0}" $$ > /dev/null
export CCACHE_DIR="$build/ccache" EM_CACHE="$build/cache" EM_FROZEN_CACHE=0
if [ ! -d "$EM_CACHE" ]; then  # the compiler's libraries; Debian's are those for few flags, and cannot be added to
    cp -r /usr/share/emscripten/cache "$EM_CACHE"
fi
prefix=$build/libraries
# All code has one kind of exceptions and of longjmp, which the machine carries out.
flags="-O3 -msimd128 -ffp-contract=off -fwasm-exceptions"

# Unpacks the source of a Debian package into a folder. Where the mirror lacks Debian's changes to it, the original is taken,
# whose sum apt has checked.
unpack() {  # PACKAGE FOLDER
    local from=$build/sources/.$1 original
    rm -rf "$from" && mkdir -p "$from"
    if (cd "$from" && apt-get source -qq "$1") > "$from.log" 2>&1; then
        mv "$from"/*/ "$2"
        return
    fi
    original=$(find "$from" -name '*.orig.tar.*' ! -name '*.asc')
    [ -n "$original" ] || { cat "$from.log" >&2; exit 1; }
    echo "build.sh: the mirror has $1 without Debian's changes" >&2
    mkdir "$from/original"
    tar -xf "$original" -C "$from/original" --strip-components=1
    mv "$from/original" "$2"
}
source_of() {
    [ -d "$build/sources/$1" ] || unpack "$1" "$build/sources/$1"
    echo "$build/sources/$1"
}
with_cmake() {  # PACKAGE OPTION...
    local from log=$build/libraries.build/$1.log
    from=$(source_of "$1")
    { emcmake cmake -S "$from" -B "$build/libraries.build/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_C_FLAGS="$flags" -DCMAKE_C_FLAGS_RELEASE=-DNDEBUG -DCMAKE_INSTALL_PREFIX="$prefix" \
        -DCMAKE_FIND_ROOT_PATH="$prefix" -DCMAKE_C_COMPILER_LAUNCHER=ccache -DBUILD_SHARED_LIBS=OFF "${@:2}" &&
        cmake --build "$build/libraries.build/$1" --target install; } > "$log" 2>&1 || { tail -n 30 "$log" >&2; exit 1; }
}
# Compiles some sources of a package: FOLDER NAME OPTION... -- SOURCE...; the library is NAME.
by_hand() {
    local from=$1 name=$2 objects=$build/libraries.build/$2 options=() made=() source
    shift 2
    mkdir -p "$objects" "$prefix/include" "$prefix/lib"
    while [ "$1" != -- ]; do options+=("$1") && shift; done
    for source in "${@:2}"; do
        made+=("$objects/$(basename "$source" .c).o")
        ccache emcc $flags "${options[@]}" -I "$objects" -I "$from" -c "$from/$source" -o "${made[-1]}"
    done
    rm -f "$prefix/lib/$name.a"
    emar rc "$prefix/lib/$name.a" "${made[@]}"
}
zlib() {
    local from
    from=$(source_of zlib)
    by_hand "$from" libz -DHAVE_UNISTD_H -- adler32.c compress.c crc32.c deflate.c inffast.c inflate.c inftrees.c trees.c \
        uncompr.c zutil.c
    cp "$from/zlib.h" "$from/zconf.h" "$prefix/include"
}
# Of Nettle only the sums and encodings that the program uses.
nettle() {
    local from objects=$build/libraries.build/libnettle
    from=$(source_of nettle)
    mkdir -p "$objects" "$prefix/include/nettle"
    : > "$objects/config.h"
    sed 's/@[A-Z_]*@/0/' "$from/version.h.in" > "$objects/version.h"
    by_hand "$from" libnettle -DHAVE_CONFIG_H -- sha256.c sha256-compress-n.c base64-encode.c \
        base64-decode.c write-be32.c memxor.c
    cp "$from"/*.h "$objects/version.h" "$prefix/include/nettle/"
}
# Headers that are the same for all machines.
headers() {
    for name in glm boost nlohmann; do ln -sfn "/usr/include/$name" "$prefix/include/$name"; done
}

if [ ! -e "$prefix/complete" ]; then
    mkdir -p "$build/libraries.build"
    zlib
    with_cmake libpng1.6 -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_TOOLS=OFF -DPNG_EXECUTABLES=OFF \
        -DPNG_HARDWARE_OPTIMIZATIONS=OFF
    with_cmake libjpeg-turbo -DWITH_SIMD=OFF -DENABLE_SHARED=OFF -DWITH_TURBOJPEG=OFF
    with_cmake freetype -DFT_DISABLE_ZLIB=ON -DFT_DISABLE_PNG=ON -DFT_DISABLE_BZIP2=ON -DFT_DISABLE_HARFBUZZ=ON \
        -DFT_DISABLE_BROTLI=ON
    nettle
    headers
    touch "$prefix/complete"
fi
emcmake cmake -S "$root" -B "$build" -G Ninja -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_CXX_FLAGS_RELEASE=-DNDEBUG \
    -DCMAKE_FIND_ROOT_PATH="$prefix" -DCANDELABRA_LIBRARIES="$prefix" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
    -DCANDELABRA_TESTS=OFF > "$build/configure.log" ||
    { cat "$build/configure.log" >&2; exit 1; }
cmake --build "$build" --target candelabra --parallel "$(nproc)"
