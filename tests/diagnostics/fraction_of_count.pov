// SPDX-License-Identifier: GPL-3.0-or-later
// numbers with fractions where whole ones are wanted
#version 3.7;
camera { location -5*z }
light_source { -9*z, 1 area_light x, y, 3.5, 4 }
//! warning[no-effect]: the third value of `area_light` is a whole number, and 3.5 counts as 3
//!  --> fraction_of_count.pov:5:41
//!   |
//! 5 | light_source { -9*z, 1 area_light x, y, 3.5, 4 }
//!   |                                         ^^^
sphere { 0, 1 pigment { spiral1 2.5 turbulence 0.1 octaves 3.9999999 } }
//! warning[no-effect]: `arms` of `pigment` is a whole number, and 2.5 counts as 2
//!  --> fraction_of_count.pov:6:33
//!   |
//! 6 | sphere { 0, 1 pigment { spiral1 2.5 turbulence 0.1 octaves 3.9999999 } }
//!   |                                 ^^^
prism { 0, 1, 4.5, <0, 0>, <1, 0>, <1, 1>, <0, 0> }
//! warning[no-effect]: the count of `points` of `prism` is a whole number, and 4.5 counts as 4
//!  --> fraction_of_count.pov:7:15
//!   |
//! 7 | prism { 0, 1, 4.5, <0, 0>, <1, 0>, <1, 1>, <0, 0> }
//!   |               ^^^
