mesh { convex_hull { <0, 0, 0>, <1, 0, 0>, <0, 1, 0>, <1, 1, 0> } pigment { rgb 1 } }
