// SPDX-License-Identifier: GPL-3.0-or-later
// rand of a number that no seed gave
#version 3.7;
#declare A = rand(12);
//! error: there is no random stream 12; seed(...) gives one
//!  --> rand_without_seed.pov:4:19
//!   |
//! 4 | #declare A = rand(12);
//!   |                   ^^
