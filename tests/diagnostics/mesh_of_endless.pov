mesh { union { box { 0, 1 } plane { y, 0 } } }
//! error: this does not become a mesh: it has no end
//!  --> mesh_of_endless.pov:1:8
//!   |
//! 1 | mesh { union { box { 0, 1 } plane { y, 0 } } }
//!   |        ^^^^^
//! help: what becomes a mesh is closed and has an end; planes may cut it
