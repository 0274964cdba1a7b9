#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Both commands of the README on a bare Debian: a debootstrap, a copy of this clone in it, examples/run.sh and tests/run.sh;
# then each source by itself, and the list of bytes.sh, in build/bytes. What is committed counts. Run by hand, as root; it
# takes 40 minutes on two idle cores, and 3 GB.
#   debian.sh SUITE FOLDER [COMMAND...]     SUITE: bookworm or trixie; COMMAND: instead of these, in the clone
# FOLDER keeps the system and FOLDER/candelabra the clone with its build: the next time only what changed is built. Without
# FOLDER/candelabra everything is built, and without FOLDER the packages come anew. MIRROR chooses where they come from.
set -euo pipefail
[ $# -ge 2 ] || { sed -n '3,8s/^# //p' "$0"; exit 2; }

suite=$1
mkdir -p "$2"
root=$(cd "$2" && pwd)
shift 2
[ $# -gt 0 ] || set -- bash -ec "examples/run.sh; tests/run.sh; tests/house/alone.sh build
                                  tests/production/bytes.sh build/candelabra > build/bytes; cat build/bytes"
clone=$(cd "$(dirname "$0")/../.." && pwd)
[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase "$suite" "$root" "${MIRROR:-http://deb.debian.org/debian}"
[ -e "$root/candelabra/.git" ] || git clone -q "$clone" "$root/candelabra"
git -C "$root/candelabra" fetch -q "$clone" HEAD
git -C "$root/candelabra" reset -q --hard FETCH_HEAD

# Within its own mounts, which end with it.
exec unshare --mount --pid --fork bash -c '
    set -euo pipefail
    mount -t proc proc "$0/proc"
    mount --rbind /dev "$0/dev"
    cp /etc/resolv.conf "$0/etc/resolv.conf"
    exec chroot "$0" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 INSTALL=yes \
        bash -c "cd /candelabra && exec \"\$@\"" debian.sh "$@"
' "$root" "$@"
