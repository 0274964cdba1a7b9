// SPDX-License-Identifier: GPL-3.0-or-later
// A word of the language with a letter too few
#version 3.7;
sphere {
    <0, 1, 0>, 1
    pigmnt { rgb <1, 0, 0> }
//! error: `sphere` has no word `pigmnt`
//!  --> misspelt_word.pov:6:5
//!   |
//! 6 |     pigmnt { rgb <1, 0, 0> }
//!   |     ^^^^^^
//! help: did you mean `pigment`?
    translate y
}
