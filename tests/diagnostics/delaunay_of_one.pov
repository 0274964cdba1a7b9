#declare Points = array[2] { <0, 0>, <1, 1> };
#declare Faces = delaunay(Points);
#declare Numbers = array[3] { 1, 2, 3 };
#declare More = delaunay(Numbers);
