mesh { convex_hull { "corner" sphere { 0, 1 } } }
