// SPDX-License-Identifier: GPL-3.0-or-later
// A comment that does not end
#version 3.7;
sphere { 0, 1 }
/* from here on
//! error: this comment has no end
//!  --> comment_not_closed.pov:5:1
//!   |
//! 5 | /* from here on
//!   | ^^
//! help: comments nest: each `/*` needs its own `*/`
box { 0, 1 }
