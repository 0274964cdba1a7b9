// SPDX-License-Identifier: GPL-3.0-or-later
// Indices begin with 0
#version 3.7;
#declare A = array[3] { 1, 2, 3 }
#for (I, 1, 3)
    sphere { A[I], 1 }
//! error: the index must be from 0 to 2, but it is 3
//!  --> array_from_one.pov:6:16
//!   |
//! 6 |     sphere { A[I], 1 }
//!   |                ^
#end
