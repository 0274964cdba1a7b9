// SPDX-License-Identifier: GPL-3.0-or-later
// A branch that opens what it does not close
#version 3.7;
#if (1)
    union {
//! error: this `{` is not closed before `#end`
//!  --> branch_opens_brace.pov:5:11
//!   |
//! 4 | #if (1)
//!   | --- what it belongs to
//! 5 |     union {
//!   |           ^
//! 6 | #end
//!   | ---- the part of the directive ends here
//! help: what a part of a directive opens it must close itself
#end
    sphere { 0, 1 }
}
