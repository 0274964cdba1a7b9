#declare Points = array[3] { <0, 0>, <1, 1>, <9, 9> };
#declare A = voronoi_cell(Points, 3, 0, 2);
#declare B = voronoi_cell(Points, 2, 0, 2);
#declare C = voronoi_cell(Points);
