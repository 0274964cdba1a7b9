// The blob is closed, but what is cut from it has no inside.
mesh {
    difference {
        sphere { 0, 1 }
        mesh { triangle { 0, x, y } }
    }
}
