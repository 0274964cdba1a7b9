mesh { convex_hull { <0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <1, 1, 0> } pigment { rgb 1 } }
//! error: this does not become a mesh: the points lie in one plane
//!  --> hull_of_plane.pov:1:8
//!   |
//! 1 | mesh { convex_hull { <0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <1, 1, 0> } pigment { rgb 1 } }
//!   |        ^^^^^^^^^^^
