// SPDX-License-Identifier: GPL-3.0-or-later
// Names that nobody has declared
#version 3.7;
#declare Radius = 2;
#declare Red = rgb <1, 0, 0>;
sphere { 0, Radios }
//! error: nothing is declared as `Radios`
//!  --> unknown_name.pov:6:13
//!   |
//! 6 | sphere { 0, Radios }
//!   |             ^^^^^^
//! help: did you mean `Radius`?
sphere { Centre, 1 }
//! error: nothing is declared as `Centre`
//!  --> unknown_name.pov:7:10
//!   |
//! 7 | sphere { Centre, 1 }
//!   |          ^^^^^^
//! help: declare it first: #declare Centre = ...;
sphere { 0, Radius*Scaling }
//! error: nothing is declared as `Scaling`
//!  --> unknown_name.pov:8:20
//!   |
//! 8 | sphere { 0, Radius*Scaling }
//!   |                    ^^^^^^^
//! help: declare it first: #declare Scaling = ...;
sphere { 0, 1 pigment { Rde } }
//! error: nothing is declared as `Rde`
//!  --> unknown_name.pov:9:25
//!   |
//! 9 | sphere { 0, 1 pigment { Rde } }
//!   |                         ^^^
//! help: did you mean `Red`?
object { Lamp translate x }
//! error: nothing is declared as `Lamp`
//!   --> unknown_name.pov:10:10
//!    |
//! 10 | object { Lamp translate x }
//!    |          ^^^^
//! help: declare it first: #declare Lamp = ...;
