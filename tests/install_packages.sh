#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what the build needs on Debian 12 and 13, where it is missing, and with --all the programs that some tests run. Called
# by tests/run.sh and examples/run.sh. It says first what it installs; INSTALL=no has it only say so, and end with 1 if
# something is missing. At a terminal it asks, unless INSTALL=yes.
set -euo pipefail

packages=(g++ cmake ninja-build bison re2c libglm-dev libtbb-dev libopenimageio-dev libpng-dev zlib1g-dev libjpeg-dev nettle-dev libseccomp-dev libfreetype-dev
          libcgal-dev libboost-dev libassimp-dev libglpk-dev fonts-povray nlohmann-json3-dev catch2 binutils python3-dev pybind11-dev python3-numpy)
[ "${1:-}" != --all ] || packages+=(chromium slurmctld slurmd slurm-client munge parallel ffmpeg mandoc python3 python3-yaml povray
                                    povray-examples povray-includes desktop-file-utils dpkg-dev file mypy
                                    python3-nbclient python3-ipykernel patchelf)
# Elsewhere these are often there from other sources.
if [ "${1:-}" = --all ]; then
    command -v node > /dev/null || packages+=(nodejs)
    command -v pkg-config > /dev/null || packages+=(pkgconf)
fi

missing=()
for package in "${packages[@]}"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
command=("${as_root[@]}" apt-get install --no-install-recommends)
echo "missing packages: ${missing[*]}"
if [ "${INSTALL:-}" = no ]; then
    echo "to install them: ${command[*]} ${missing[*]}"
    exit 1
fi
echo "installing them:  ${command[*]} -y ${missing[*]}"
echo "to do without: INSTALL=no before the command; then only those that are there are used"
if [ -t 0 ] && [ "${INSTALL:-}" != yes ]; then
    read -r -p "Install them? [Y/n] " answer
    case $answer in [nN]*) exit 1 ;; esac
fi
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${command[@]}" -y -qq "${missing[@]}"
