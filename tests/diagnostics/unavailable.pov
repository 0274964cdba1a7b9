// SPDX-License-Identifier: GPL-3.0-or-later
// Words of POV-Ray that this version has not
#version 3.7;
sphere { 0, 1 interior { anisotropy { 1 } } }
//! error: `anisotropy` is not available in this version
//!  --> unavailable.pov:4:26
//!   |
//! 4 | sphere { 0, 1 interior { anisotropy { 1 } } }
//!   |                          ^^^^^^^^^^
light_source { 0, 1 spotlight point_at z radius 10 falloff 20 }
sphere { 0, 1 texture { pigment { rgb 1 } } texture { pigment { rgbt 0.5 } } }
global_settings { radiosity { count 100 } }
//! warning[no-effect]: `count` of `radiosity` has no effect: light is gathered without a cache
//!  --> unavailable.pov:7:19
//!   |
//! 7 | global_settings { radiosity { count 100 } }
//!   |                   ^^^^^^^^^
sphere { 0, 1 bounded_by { box { -1, 1 } } }
