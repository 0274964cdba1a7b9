mesh { box { -1, 1 } subdivide 9 }
