#declare A = array(3);
//! error: the size of an array stands in square brackets
//!  --> array_in_parentheses.pov:1:14
//!   |
//! 1 | #declare A = array(3);
//!   |              ^^^^^^^^
//! help: array[3], or array { 1, 2, 3 }
