// SPDX-License-Identifier: GPL-3.0-or-later
// An error inside a macro of an include file, in a loop
#version 3.7;
#include "parts.inc"
union {
    Washers(2)
}
