// SPDX-License-Identifier: GPL-3.0-or-later
// A parameter that is not used
#version 3.7;
#macro Lamp(Height, Size)
//! warning[unused-parameter]: macro `Lamp` does not use its parameter `Height`
//!  --> parameter_shadows.pov:4:13
//!   |
//! 4 | #macro Lamp(Height, Size)
//!   |             ^^^^^^
    sphere { 2*y, Size }
#end
Lamp(1, 2)
