#version 3.7;
#declare A = array[3] (1, 2, 3);
//! error: values in parentheses are no elements
//!  --> array_elements_in_parentheses.pov:2:23
//!   |
//! 2 | #declare A = array[3] (1, 2, 3);
//!   |                       ^^^^^^^^^
//! help: the elements of an array stand in braces: { 1, 2, 3 }
