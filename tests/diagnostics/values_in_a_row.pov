#version 3.7;
#declare A = 5 6;
//! error: between this value and the next an operator is missing, or a `;`
//!  --> values_in_a_row.pov:2:15
//!   |
//! 2 | #declare A = 5 6;
//!   |               ^
//! help: a product is written with its sign: 2*(3 + 4), 2*sin(1)
#declare B = 2(3 + 4);
//! error: between this value and the next an operator is missing, or a `;`
//!  --> values_in_a_row.pov:3:15
//!   |
//! 3 | #declare B = 2(3 + 4);
//!   |               ^
//! help: a product is written with its sign: 2*(3 + 4), 2*sin(1)
#declare C = 2sin(1);
//! error: between this value and the next an operator is missing, or a `;`
//!  --> values_in_a_row.pov:4:15
//!   |
//! 4 | #declare C = 2sin(1);
//!   |               ^
//! help: a product is written with its sign: 2*(3 + 4), 2*sin(1)
#declare D = 1, 2, 3;
//! error: a `;` is missing after this value
//!  --> values_in_a_row.pov:5:15
//!   |
//! 5 | #declare D = 1, 2, 3;
//!   |               ^
//! help: a number is written with a point, 1.5, and a vector in <1, 2, 3>
#declare E = <1, 2, 3>[1];
//! error: only arrays have elements
//!  --> values_in_a_row.pov:6:23
//!   |
//! 6 | #declare E = <1, 2, 3>[1];
//!   |                       ^
//! help: the parts of a vector are V.x, V.y, V.z
