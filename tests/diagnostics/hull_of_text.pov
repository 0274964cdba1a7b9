mesh { convex_hull { "corner" sphere { 0, 1 } } }
//! error: a point of `convex_hull` must be a vector of 3, but it is a string
//!  --> hull_of_text.pov:1:22
//!   |
//! 1 | mesh { convex_hull { "corner" sphere { 0, 1 } } }
//!   |                      ^^^^^^^^ this is a string
//! help: convex_hull { points and objects, in any order }
