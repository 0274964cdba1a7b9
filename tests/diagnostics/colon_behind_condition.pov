#if (1): sphere { 0, 1 } #end
//! error: `:` does not fit here
//!  --> colon_behind_condition.pov:1:8
//!   |
//! 1 | #if (1): sphere { 0, 1 } #end
//!   |        ^
//! help: no `:` stands behind a condition
