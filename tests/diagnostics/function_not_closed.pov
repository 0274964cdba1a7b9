isosurface { function { x*x - 1 contained_by { box { -1, 1 } } }
