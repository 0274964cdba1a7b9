mesh { file 3 }
//! error: `file` of `mesh` must be a string, but it is a number
//!  --> mesh_file_number.pov:1:13
//!   |
//! 1 | mesh { file 3 }
//!   |             ^ this is a number
//! help: mesh { ... file v ... }   file: string, default ""
