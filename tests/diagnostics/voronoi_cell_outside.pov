#declare Points = array[3] { <0, 0>, <1, 1>, <9, 9> };
#declare A = voronoi_cell(Points, 3, 0, 2);
//! error: there is no point 3: there are 3, counted from 0
//!  --> voronoi_cell_outside.pov:2:35
//!   |
//! 2 | #declare A = voronoi_cell(Points, 3, 0, 2);
//!   |                                   ^
#declare B = voronoi_cell(Points, 2, 0, 2);
//! error: point 2 has no cell: it lies on another one, or outside of the rectangle
//!  --> voronoi_cell_outside.pov:3:35
//!   |
//! 3 | #declare B = voronoi_cell(Points, 2, 0, 2);
//!   |                                   ^
#declare C = voronoi_cell(Points);
//! error: `voronoi_cell` takes 4 arguments, but here is 1
//!  --> voronoi_cell_outside.pov:4:14
//!   |
//! 4 | #declare C = voronoi_cell(Points);
//!   |              ^^^^^^^^^^^^^^^^^^^^
//! help: voronoi_cell(points, i, low, high): what is nearer to point i <x, y> of an array than to the others, within a rectangle: an array of its corners
