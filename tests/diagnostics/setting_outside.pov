// SPDX-License-Identifier: GPL-3.0-or-later
// What old scenes write outside of global_settings, and without its sign
#version 3.7;
max_trace_level 7
default { finish { ambient 0.2 } }
camera { location <0, 0, -9> look_at 0 }
light_source { <9, 9, -9>, 1 }
sphere { 0, 1 pigment { rgb 1 } }
//! warning[deprecated]: `default` should have a # before it
//!  --> setting_outside.pov:5:1
//!   |
//! 5 | default { finish { ambient 0.2 } }
//!   | ^^^^^^^
//! help: write `#default`
//! warning[deprecated]: `max_trace_level` belongs into `global_settings`
//!  --> setting_outside.pov:4:1
//!   |
//! 4 | max_trace_level 7
//!   | ^^^^^^^^^^^^^^^
//! help: global_settings { max_trace_level 5 }
