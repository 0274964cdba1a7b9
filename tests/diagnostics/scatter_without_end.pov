#declare Places = scatter(plane { y, 0 }, 0.1);
//! error: this object has no end
//!  --> scatter_without_end.pov:1:27
//!   |
//! 1 | #declare Places = scatter(plane { y, 0 }, 0.1);
//!   |                           ^^^^^^^^^^^^^^
