mesh { sphere { 0, 1 } resolution 2 }
