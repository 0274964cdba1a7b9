#declare A = sin 30;
//! error: expected `(`, but found `30`
//!  --> function_without_parentheses.pov:1:18
//!   |
//! 1 | #declare A = sin 30;
//!   |                  ^^
//! help: the arguments of a function stand in parentheses: sin(...)
#declare R = seed;
//! error: expected `(`, but found `;`
//!  --> function_without_parentheses.pov:2:18
//!   |
//! 2 | #declare R = seed;
//!   |                  ^
//! help: the arguments of a function stand in parentheses: seed(...)
