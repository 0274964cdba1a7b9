// SPDX-License-Identifier: GPL-3.0-or-later
// A file that includes itself
#version 3.7;
#include "itself.inc"
//! error: files include each other 100 deep, which is the limit
//!  --> itself.inc:2:1
//!   |
//! 2 | #include "itself.inc"
//!   | ^^^^^^^^^^^^^^^^^^^^^
//!   |
//!   = `itself.inc` is included at itself.inc:2:10
//!   = `itself.inc` is included at itself.inc:2:10
//!   = `itself.inc` is included at itself.inc:2:10
//!   = `itself.inc` is included at itself.inc:2:10
//!   = `itself.inc` is included at itself.inc:2:10
//!   = ... 90 more
//!   = `itself.inc` is included at itself.inc:2:10
//!   = `itself.inc` is included at itself.inc:2:10
//!   = `itself.inc` is included at itself.inc:2:10
//!   = `itself.inc` is included at itself.inc:2:10
//!   = `itself.inc` is included at include_itself.pov:4:10
//! help: a file that includes itself needs an #ifndef that ends it; --limit-includes raises the limit
