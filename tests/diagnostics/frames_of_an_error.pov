// SPDX-License-Identifier: GPL-3.0-or-later
// An error inside a macro of an include file, in a loop
#version 3.7;
#include "parts.inc"
union {
    Washers(2)
}
//! error: `bottom_radius` of `ovus` must be at least 0, but it is -2
//!  --> parts.inc:4:12
//!   |
//! 4 |     ovus { Gauge - 6, 1 }
//!   |            ^^^^^^^^^ this is -2
//!   |
//!   = in macro `Washer`, called at parts.inc:8:18
//!   = in macro `Washers`, called at frames_of_an_error.pov:6:5
//!   = `parts.inc` is included at frames_of_an_error.pov:4:10
//! help: ovus { bottom_radius, top_radius }   bottom_radius: number from 0 on
//! error: `bottom_radius` of `ovus` must be at least 0, but it is -1
//!  --> parts.inc:4:12
//!   |
//! 4 |     ovus { Gauge - 6, 1 }
//!   |            ^^^^^^^^^ this is -1
//!   |
//!   = in macro `Washer`, called at parts.inc:8:18
//!   = in macro `Washers`, called at frames_of_an_error.pov:6:5
//!   = `parts.inc` is included at frames_of_an_error.pov:4:10
//! help: ovus { bottom_radius, top_radius }   bottom_radius: number from 0 on
