union { M()
sphere{5,1}
}
#macro M() sphere { 0, 1
//! error: this `{` is not closed before `#end`
//!  --> open_macro_in_a_block.pov:4:19
//!   |
//! 4 | #macro M() sphere { 0, 1
//!   | ------            ^
//!   | |
//!   | what it belongs to
//! 5 | #end
//!   | ---- the macro ends here
//! help: add the missing `}`; or let another macro, defined outside of directives as this one is, close it: #macro End() } #end
#end
