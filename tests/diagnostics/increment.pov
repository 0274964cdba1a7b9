// SPDX-License-Identifier: GPL-3.0-or-later
// i++
#version 3.7;
#declare I = 0;
#while (I < 3)
    I++;
//! error: expected a value, but found `;`
//!  --> increment.pov:6:8
//!   |
//! 6 |     I++;
//!   |        ^
//! help: a value is changed by `#declare I = I + 1;`
#end
