// SPDX-License-Identifier: GPL-3.0-or-later
// One word written as two
#version 3.7;
camera { location <0,0,-5> look at 0 }
//! error: `camera` has no word `look`
//!  --> look_at_as_two_words.pov:4:28
//!   |
//! 4 | camera { location <0,0,-5> look at 0 }
//!   |                            ^^^^
//! help: did you mean `look_at`?
