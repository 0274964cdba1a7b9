// SPDX-License-Identifier: GPL-3.0-or-later
// A space of another kind
#version 3.7;
sphere { <0, 1, 0>, 1 }
//! error: this is a no-break space
//!  --> no_break_space.pov:4:16
//!   |
//! 4 | sphere { <0, 1, 0>, 1 }
//!   |                ^
//! help: write an ordinary blank
