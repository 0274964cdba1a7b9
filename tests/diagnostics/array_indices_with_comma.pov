// SPDX-License-Identifier: GPL-3.0-or-later
// Indices side by side
#version 3.7;
#declare A = array[2][2] {{1,2},{3,4}} #declare B = A[1,0];
//! error: expected `]`, but found `,`
//!  --> array_indices_with_comma.pov:4:56
//!   |
//! 4 | #declare A = array[2][2] {{1,2},{3,4}} #declare B = A[1,0];
//!   |                                                      - ^
//!   |                                                      |
//!   |                                                      opened here
//! help: each index has its own brackets: A[1][2]
