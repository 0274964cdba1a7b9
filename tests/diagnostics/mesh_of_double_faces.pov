// A file that has each face twice bounds no solid; CGAL 6 crashed on it.
#declare Sheet = mesh2 {
    vertex_vectors { 3, 0, x, y }
    face_indices { 2, <0, 1, 2>, <0, 1, 2> }
    inside_vector z
}
mesh {
    union {
        object { Sheet }
        object { Sheet translate 0.25 * x }
    }
}
