// SPDX-License-Identifier: GPL-3.0-or-later
// A #break that leaves nothing
#version 3.7;
#break
//! error: this #break is in no loop, #switch or macro that it could leave
//!  --> break_alone.pov:4:1
//!   |
//! 4 | #break
//!   | ^^^^^^
