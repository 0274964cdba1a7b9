#declare A = 1;
#if (A = 1) then
//! error: nothing is declared as `then`
//!  --> if_then.pov:2:13
//!   |
//! 2 | #if (A = 1) then
//!   |             ^^^^
//! help: an #if needs no `then`: #if (A) ... #else ... #end
    sphere { 0, 1 }
#end
