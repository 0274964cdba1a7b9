// SPDX-License-Identifier: GPL-3.0-or-later
// A `)` is missing
#version 3.7;
#declare A = (1 + 2 * (3 - 4);
//! error: expected `)` or `,`, but found `;`
//!  --> parenthesis_missing.pov:4:30
//!   |
//! 4 | #declare A = (1 + 2 * (3 - 4);
//!   |              -               ^
//!   |              |
//!   |              opened here
#declare B = 2;
