// A file that has each face twice bounds no solid; CGAL 6 crashed on it.
#declare Sheet = mesh2 {
    vertex_vectors { 3, 0, x, y }
    face_indices { 2, <0, 1, 2>, <0, 1, 2> }
    inside_vector z
}
mesh {
    union {
//! error: this does not become a mesh: surface 1 bounds no solid: two of its faces have the same corners
//!  --> mesh_of_double_faces.pov:8:5
//!   |
//! 8 |     union {
//!   |     ^^^^^
//! help: what becomes a mesh is closed and has an end; planes may cut it
        object { Sheet }
        object { Sheet translate 0.25 * x }
    }
}
