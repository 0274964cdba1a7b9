#declare Places = scatter(3, 0.1);
//! error: `scatter` takes a declared object here, but this is a number
//!  --> scatter_of_number.pov:1:27
//!   |
//! 1 | #declare Places = scatter(3, 0.1);
//!   |                           ^
