#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and renders the paper's pair of sphereflakes to sphereflakes.png.
set -euo pipefail
cd "$(dirname "$0")/.."

tests/install_packages.sh
build=${BUILD_DIR:-build}
cmake -S . -B "$build" -G Ninja -DCANDELABRA_TESTS=OFF
cmake --build "$build"
"$build/candelabra" examples/paper/fig6.pov +W640 +H640 +Osphereflakes.png
echo "sphereflakes.png: 7381 diffuse spheres beside 7381 luminaires (examples/paper/fig6.pov)"
