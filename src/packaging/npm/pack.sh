#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the npm package of the program that ../wasm/build.sh has built: BUILD/candelabra-VERSION.tgz.
#   pack.sh [BUILD]   BUILD: default build-wasm
set -euo pipefail

own=$(realpath "$(dirname "$0")")
root=$(realpath "$own/../../..")
build=$(realpath "${1:-$root/build-wasm}")
version=$(sed -n 's/^project(candelabra VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
package=$build/npm/package
rm -rf "$build/npm"
mkdir -p "$package"
cp -r "$own/bin" "$own/lib" "$own/index.mjs" "$own/index.d.ts" "$own/README.md" "$root/LICENSE" "$root/stdlib" "$package"
mkdir "$package/examples"
# Scenes with what they read, if WebAssembly has all that they need; pictures of all of them would be most of the package.
(cd "$root/examples" && tar -c --exclude='*.sh' --exclude=./pictures --exclude=./python --exclude='model_street.*' \
    --exclude=modelling.pov .) | tar -x -C "$package/examples"
cp "$build/candelabra.mjs" "$build/candelabra.wasm" "$package/lib"
sed "s/@VERSION@/$version/" "$own/package.json" > "$package/package.json"
# Sorted, and without times and owners: the same bytes from the same files.
made=$build/candelabra-$version.tgz
tar -C "$build/npm" --sort=name --owner=0 --group=0 --numeric-owner --mtime=@0 -c package | gzip -9n > "$made"
echo "$made: $(stat -c %s "$made") bytes"
