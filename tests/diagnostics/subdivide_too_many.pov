mesh { sphere { 0, 1 } resolution 400 subdivide 6 }
