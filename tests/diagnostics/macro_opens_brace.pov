#version 3.7;
#macro Open() union { #end
//! error: this `{` is not closed before `#end`
//!  --> macro_opens_brace.pov:2:21
//!   |
//! 2 | #macro Open() union { #end
//!   | ------              ^ ---- the macro ends here
//!   | |
//!   | what it belongs to
//! help: add the missing `}`; or let another macro, defined outside of directives as this one is, close it: #macro End() } #end
#for (I, 1, 2)
    Open() sphere { 0, 1 }
#end
