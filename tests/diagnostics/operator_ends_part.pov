#version 3.7;
#declare A = 1;
#declare B = (#if (A) 2 + #end);
//! error: an operator in this has no value behind it
//!  --> operator_ends_part.pov:3:15
//!   |
//! 3 | #declare B = (#if (A) 2 + #end);
//!   |               ^^^^^^^^^^^^^^^^
//! help: where a part of a directive ends in an operator, a value follows: #if (A) 2 * #end 3
