mesh { sphere { 0, 1 } resolution 400 subdivide 6 }
//! error: `subdivide 6` would make more than 30000000 faces of 638400
//!  --> subdivide_too_many.pov:1:1
//!   |
//! 1 | mesh { sphere { 0, 1 } resolution 400 subdivide 6 }
//!   | ^^^^
