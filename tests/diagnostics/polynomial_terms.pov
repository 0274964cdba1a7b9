#declare A = polynomial { 2, xyz(2, 0, 0): 1, xyz(2, 0, 1): 3 }
//! error: xyz(2, 0, 1) is of a higher degree than the 2 of its `polynomial`
//!  --> polynomial_terms.pov:1:14
//!   |
//! 1 | #declare A = polynomial { 2, xyz(2, 0, 0): 1, xyz(2, 0, 1): 3 }
//!   |              ^^^^^^^^^^
//! help: polynomial { degree [xyz { ... }] }
#declare B = polynomial { 2, xyz(-1, 0, 0): 1 }
//! error: `x` of `xyz` must be from 0 to 35, but it is -1
//!  --> polynomial_terms.pov:2:34
//!   |
//! 2 | #declare B = polynomial { 2, xyz(-1, 0, 0): 1 }
//!   |                                  ^^ this is -1
//! help: xyz { x, y, z, factor }   x: whole number from 0 to 35
#declare C = polynomial { 40, xyz(1, 0, 0): 1 }
//! error: `degree` of `polynomial` must be from 2 to 35, but it is 40
//!  --> polynomial_terms.pov:3:27
//!   |
//! 3 | #declare C = polynomial { 40, xyz(1, 0, 0): 1 }
//!   |                           ^^ this is 40
//! help: polynomial { degree [xyz { ... }] }   degree: whole number from 2 to 35
#declare D = polynomial { 3, xyz(1, 0): 1 }
//! error: `xyz` needs `factor`
//!  --> polynomial_terms.pov:4:30
//!   |
//! 4 | #declare D = polynomial { 3, xyz(1, 0): 1 }
//!   |                              ^^^
//! help: xyz { x, y, z, factor }
