// SPDX-License-Identifier: GPL-3.0-or-later
// A comparison among exponents
#version 3.7;
polynomial { 2, xyz(1>2,0,0):1, xyz(0,2,0):1 }
//! error: expected `)` or `,`, but found `>`
//!  --> polynomial_comparison.pov:4:22
//!   |
//! 4 | polynomial { 2, xyz(1>2,0,0):1, xyz(0,2,0):1 }
//!   |                    - ^
//!   |                    |
//!   |                    opened here
//! help: comparisons and conditions are written in parentheses: (a > b)
