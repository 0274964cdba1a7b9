#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Starts the program with the C library that lies beside it, so that the system's may be of any age.
own=$(readlink -f "$0")
root=${own%/*/*}
exec "$root/libexec/loader" --library-path "$root/lib/candelabra" "$root/libexec/candelabra" "$@"
