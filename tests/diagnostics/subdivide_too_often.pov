mesh { box { -1, 1 } subdivide 9 }
//! error: `subdivide` of `mesh` must be from 0 to 8, but it is 9
//!  --> subdivide_too_often.pov:1:32
//!   |
//! 1 | mesh { box { -1, 1 } subdivide 9 }
//!   |                                ^ this is 9
//! help: mesh { ... subdivide n ... }   subdivide: whole number from 0 to 8, default 0
