#declare Places = scatter(sphere { 0, 1 }, 0);
//! error: the distance must be above 0
//!  --> scatter_distance.pov:1:44
//!   |
//! 1 | #declare Places = scatter(sphere { 0, 1 }, 0);
//!   |                                            ^
#declare More = scatter(sphere { 0, 1 }, 1e-5);
//! error: so small a distance would give more than 1000000 points
//!  --> scatter_distance.pov:2:42
//!   |
//! 2 | #declare More = scatter(sphere { 0, 1 }, 1e-5);
//!   |                                          ^^^^
