// SPDX-License-Identifier: GPL-3.0-or-later
// A setting in an object
#version 3.7;
sphere { 0, 1 max_trace_level 3 }
//! error: `max_trace_level` has no place in `sphere`
//!  --> settings_in_object.pov:4:15
//!   |
//! 4 | sphere { 0, 1 max_trace_level 3 }
//!   |               ^^^^^^^^^^^^^^^
//!   |
//!   = it belongs in `global_settings`, `photons`
//! help: sphere { centre, radius }
