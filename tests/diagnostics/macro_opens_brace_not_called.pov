#version 3.7;
#macro Lamp(At)
    light_source { At, rgb 1
//! error: this `{` is not closed before `#end`
//!  --> macro_opens_brace_not_called.pov:3:18
//!   |
//! 2 | #macro Lamp(At)
//!   | ------ what it belongs to
//! 3 |     light_source { At, rgb 1
//!   |                  ^
//! 4 | #end
//!   | ---- the macro ends here
//! help: add the missing `}`; or let another macro, defined outside of directives as this one is, close it: #macro End() } #end
#end
sphere { 0, 1 }
