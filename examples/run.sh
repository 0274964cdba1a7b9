#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the program and renders the paper's pair of sphereflakes to sphereflakes.png. What the build needs and Debian 12 or 13
# has is installed before, which is said and, at a terminal, asked. To do without:
#   INSTALL=no examples/run.sh            # says what is missing, and builds with what is there
#   CANDELABRA=candelabra examples/run.sh # renders by a program that is there, and builds nothing
set -euo pipefail
cd "$(dirname "$0")/.."

build=${BUILD_DIR:-build}
program=${CANDELABRA:-$build/candelabra}
if [ -z "${CANDELABRA:-}" ]; then
    tests/install_packages.sh || [ "${INSTALL:-}" = no ]
    cmake -S . -B "$build" -G Ninja -DCANDELABRA_TESTS=OFF
    cmake --build "$build"
fi
"$program" examples/paper/fig6.pov +W640 +H640 +Osphereflakes.png
echo "sphereflakes.png: 7381 diffuse spheres beside 7381 luminaires (examples/paper/fig6.pov)"
