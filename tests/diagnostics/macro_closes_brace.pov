#version 3.7;
#macro Close() } #end
//! error: `}` closes nothing that is open
//!  --> macro_closes_brace.pov:2:16
//!   |
//! 2 | #macro Close() } #end
//!   | ------         ^
//!   | |
//!   | the innermost that is open
//! help: leave it out; or let another macro, defined outside of directives as this one is, open it: #macro Begin() union { #end
sphere { 0, 1 }
Close()
