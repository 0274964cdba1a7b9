#declare Rabbit = mesh { file "rabbit.ply" smooth }
//! error: there is no file `rabbit.ply`
//!  --> mesh_file_missing.pov:1:31
//!   |
//! 1 | #declare Rabbit = mesh { file "rabbit.ply" smooth }
//!   |                               ^^^^^^^^^^^^
//!   |
//!   = looked in the current directory
object { Rabbit }
