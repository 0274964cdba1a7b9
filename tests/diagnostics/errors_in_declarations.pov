#declare A = 2 ** 3;
//! error: expected a value, but found `*`
//!  --> errors_in_declarations.pov:1:17
//!   |
//! 1 | #declare A = 2 ** 3;
//!   |                 ^
//! help: a power is pow(base, exponent)
#declare B := 5;
//! error: expected `=`, but found `:`
//!  --> errors_in_declarations.pov:2:12
//!   |
//! 2 | #declare B := 5;
//!   |            ^
//! help: a name gets its value by `=` alone: #declare A = 1;
#declare C = 5;
