mesh { triangle { 0, x, y } file "rabbit.ply" }
//! error: a `mesh` is made of triangles, a file, an object or a hull, not of several of these
//!  --> mesh_of_triangles_and_file.pov:1:1
//!   |
//! 1 | mesh { triangle { 0, x, y } file "rabbit.ply" }
//!   | ^^^^
