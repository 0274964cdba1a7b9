// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes side by side
#version 3.7;
#declare A = array[3,4];
//! error: expected `]`, but found `,`
//!  --> array_sizes_with_comma.pov:4:21
//!   |
//! 4 | #declare A = array[3,4];
//!   |                   - ^
//!   |                   |
//!   |                   opened here
//! help: each index has its own brackets: A[1][2]
