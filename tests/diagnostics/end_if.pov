#if (1) sphere { 0, 1 } #end if
//! error: `#end` ends any directive, and no `if` follows it
//!  --> end_if.pov:1:30
//!   |
//! 1 | #if (1) sphere { 0, 1 } #end if
//!   |                              ^^
//! help: write `#end`
