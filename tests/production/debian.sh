#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Both commands of the README on a bare Debian: a debootstrap, a copy of this clone in it, examples/run.sh and tests/run.sh.
# Run by hand, as root; it takes 20 minutes on two idle cores, and 5 GB.
#   debian.sh SUITE FOLDER     SUITE: bookworm or trixie; FOLDER keeps the system for the next time
# MIRROR chooses where packages come from. Afterwards FOLDER/candelabra has the clone with its build.
set -euo pipefail
[ $# -eq 2 ] || { sed -n '3,6s/^# //p' "$0"; exit 2; }

suite=$1
mkdir -p "$2"
root=$(cd "$2" && pwd)
clone=$(cd "$(dirname "$0")/../.." && pwd)
[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase "$suite" "$root" "${MIRROR:-http://deb.debian.org/debian}"
rm -rf "$root/candelabra"
git clone -q "$clone" "$root/candelabra"

# Within its own mounts, which end with it.
exec unshare --mount --pid --fork bash -c '
    set -euo pipefail
    mount -t proc proc "$0/proc"
    mount --rbind /dev "$0/dev"
    cp /etc/resolv.conf "$0/etc/resolv.conf"
    exec chroot "$0" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 INSTALL=yes \
        bash -ec "cd /candelabra; examples/run.sh; tests/run.sh"
' "$root"
