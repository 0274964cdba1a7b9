// SPDX-License-Identifier: GPL-3.0-or-later
// What is written before where to
#version 3.7;
#fopen F "lg_x.txt" write #write (1, F)
//! error: a scene may not write `lg_x.txt`
//!  --> write_of_number_first.pov:4:10
//!   |
//! 4 | #fopen F "lg_x.txt" write #write (1, F)
//!   |          ^^^^^^^^^^
//!   |
//!   = this run writes no files
//! help: `--allow-write .` allows it
