// SPDX-License-Identifier: GPL-3.0-or-later
// #default for the rest of a #switch
#version 3.7;
#switch (5)
  #case (5) sphere { 0, 1 }
  #default sphere { 0, 2 }
//! error: expected `{`, but found `sphere`
//!  --> default_in_switch.pov:6:12
//!   |
//! 6 |   #default sphere { 0, 2 }
//!   |            ^^^^^^
//! help: the last part of a #switch is `#else`
#end
