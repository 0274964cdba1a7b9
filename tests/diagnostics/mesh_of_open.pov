// The blob is closed, but what is cut from it has no inside.
mesh {
    difference {
        sphere { 0, 1 }
        mesh { triangle { 0, x, y } }
    }
}
//! warning[no-effect]: this has no inside, so it cuts nothing off the others
//!  --> mesh_of_open.pov:5:9
//!   |
//! 5 |         mesh { triangle { 0, x, y } }
//!   |         ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
//! help: triangles have no inside; a mesh gets one by inside_vector
//! error: this does not become a mesh: surface 2 bounds no solid: it is not closed
//!  --> mesh_of_open.pov:3:5
//!   |
//! 3 |     difference {
//!   |     ^^^^^^^^^^
//! help: what becomes a mesh is closed and has an end; planes may cut it
