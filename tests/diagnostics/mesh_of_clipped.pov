mesh { sphere { 0, 1 clipped_by { plane { y, 0 } } } }
