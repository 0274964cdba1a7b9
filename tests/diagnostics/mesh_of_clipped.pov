mesh { sphere { 0, 1 clipped_by { plane { y, 0 } } } }
//! error: this does not become a mesh: `clipped_by` leaves it open; use `intersection`
//!  --> mesh_of_clipped.pov:1:8
//!   |
//! 1 | mesh { sphere { 0, 1 clipped_by { plane { y, 0 } } } }
//!   |        ^^^^^^
//! help: what becomes a mesh is closed and has an end; planes may cut it
