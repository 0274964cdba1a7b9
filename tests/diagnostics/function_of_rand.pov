#declare S = seed(1);
#declare F = function(X) { X*rand(S) }
//! error: `rand` cannot be used in functions
//!  --> function_of_rand.pov:2:30
//!   |
//! 2 | #declare F = function(X) { X*rand(S) }
//!   |                              ^^^^^^^
//! help: a function has the same value at every call; at random over space is f_noise3d(x, y, z) of functions.inc
