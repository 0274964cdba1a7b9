M()
#macro M() sphere { 0, 1
//! error: this `{` is not closed before `#end`
//!  --> open_macro_called_too_early.pov:2:19
//!   |
//! 2 | #macro M() sphere { 0, 1
//!   | ------            ^
//!   | |
//!   | what it belongs to
//! 3 | #end
//!   | ---- the macro ends here
//! help: add the missing `}`; or let another macro, defined outside of directives as this one is, close it: #macro End() } #end
#end
