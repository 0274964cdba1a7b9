// SPDX-License-Identifier: GPL-3.0-or-later
// Marks a loop that is compiled for several instruction sets; the widest one of the machine is
// selected at program start. The results are identical to the last bit.
#pragma once

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define CANDELABRA_TARGET_CLONES \
    [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
#else
#define CANDELABRA_TARGET_CLONES
#endif
