#declare A = 0;
#if (1) sphere { 0, 1 } #end if (A) sphere { x, 1 } #end
//! error: `if` needs a # before it
//!  --> end_if_again.pov:2:30
//!   |
//! 2 | #if (1) sphere { 0, 1 } #end if (A) sphere { x, 1 } #end
//!   |                              ^^
//! help: write `#if`; `#end` ends any directive by itself
