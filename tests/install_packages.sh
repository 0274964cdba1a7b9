#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what the build needs on Debian 12, where it is missing, and with --all the programs that some tests run. Called
# by tests/run.sh and examples/run.sh.
set -euo pipefail

packages=(g++ cmake ninja-build bison re2c libglm-dev libtbb-dev libopenimageio-dev libpng-dev zlib1g-dev libjpeg-dev nettle-dev libseccomp-dev libfreetype-dev
          libcgal-dev libboost-dev fonts-povray nlohmann-json3-dev catch2 binutils)
[ "${1:-}" != --all ] || packages+=(chromium slurmctld slurmd slurm-client munge parallel ffmpeg mandoc python3 python3-yaml povray
                                    povray-examples povray-includes)

missing=()
for package in "${packages[@]}"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
if [ ${#missing[@]} -gt 0 ]; then
    echo "installing: ${missing[*]}"
    as_root=()
    [ "$(id -u)" -eq 0 ] || as_root=(sudo)
    "${as_root[@]}" apt-get update -qq
    DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}"
fi
