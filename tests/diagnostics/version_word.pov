// SPDX-License-Identifier: GPL-3.0-or-later
// A version in words
#version unofficial megapov 1.0;
//! error: this scene is written for `megapov`, a patched POV-Ray whose additions are not known here
//!  --> version_word.pov:3:10
//!   |
//! 3 | #version unofficial megapov 1.0;
//!   |          ^^^^^^^^^^^^^^^^^^^^^^
//! help: write `#version 3.7;`, and what only that program has will be reported
