mesh { sphere { 0, 1 } resolution 2 }
//! error: `resolution` of `mesh` must be from 4 to 512, but it is 2
//!  --> resolution_too_coarse.pov:1:35
//!   |
//! 1 | mesh { sphere { 0, 1 } resolution 2 }
//!   |                                   ^ this is 2
//! help: mesh { ... resolution n ... }   resolution: whole number from 4 to 512, default 64
