// SPDX-License-Identifier: GPL-3.0-or-later
// A blob has no boxes
#version 3.7;
blob { threshold 0.5 box { 0, 1 } }
//! error: `box` has no place in `blob`
//!  --> blob_of_box.pov:4:22
//!   |
//! 4 | blob { threshold 0.5 box { 0, 1 } }
//!   |                      ^^^
//! help: blob { [threshold n] [sphere { ... }] [cylinder { ... }] [component ...] }
