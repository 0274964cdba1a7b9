// SPDX-License-Identifier: GPL-3.0-or-later
// A setting that does not exist
#version 3.7;
global_settings { ambient_lights 1 }
//! error: `global_settings` has no word `ambient_lights`
//!  --> settings_unknown.pov:4:19
//!   |
//! 4 | global_settings { ambient_lights 1 }
//!   |                   ^^^^^^^^^^^^^^
//! help: did you mean `ambient_light`?
