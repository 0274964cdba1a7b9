// SPDX-License-Identifier: GPL-3.0-or-later
// Comments nest
#version 3.7;
/* outer /* inner */
//! error: this comment has no end
//!  --> comment_nested.pov:4:1
//!   |
//! 4 | /* outer /* inner */
//!   | ^^
//! help: comments nest: each `/*` needs its own `*/`
sphere { 0, 1 }
