#declare Points = array[2] { <0, 0>, <1, 1> };
#declare Faces = delaunay(Points);
//! error: the points lie on one line
//!  --> delaunay_of_one.pov:2:27
//!   |
//! 2 | #declare Faces = delaunay(Points);
//!   |                           ^^^^^^
#declare Numbers = array[3] { 1, 2, 3 };
#declare More = delaunay(Numbers);
//! error: the points are an array of vectors <x, y>
//!  --> delaunay_of_one.pov:4:26
//!   |
//! 4 | #declare More = delaunay(Numbers);
//!   |                          ^^^^^^^
