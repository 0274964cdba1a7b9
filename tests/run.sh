#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs all tests. BUILD_DIR chooses the folder (default: build).
set -euo pipefail
cd "$(dirname "$0")/.."

tests/install_packages.sh
build=${BUILD_DIR:-build}
cmake -S . -B "$build" -G Ninja -DCANDELABRA_TESTS=ON
cmake --build "$build"
ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)"
