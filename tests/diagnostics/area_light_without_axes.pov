// SPDX-License-Identifier: GPL-3.0-or-later
// An area light without its axes
#version 3.7;
light_source { 0, rgb 1 area_light 5, 5 }
//! error: the third value of `area_light` is missing, a whole number
//!  --> area_light_without_axes.pov:4:25
//!   |
//! 4 | light_source { 0, rgb 1 area_light 5, 5 }
//!   |                         ^^^^^^^^^^
//! help: light_source { ... area_light v, v, n, n ... }   the third value: whole number from 0 to 1000, default 0
