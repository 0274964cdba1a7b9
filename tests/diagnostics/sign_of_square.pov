#declare A = 3²;
//! error: this is a sign for a square, which is written X*X
//!  --> sign_of_square.pov:1:15
//!   |
//! 1 | #declare A = 3²;
//!   |               ^
#declare B = √2;
//! error: this is a sign for a root, which is written sqrt(X)
//!  --> sign_of_square.pov:2:14
//!   |
//! 2 | #declare B = √2;
//!   |              ^
#declare C = A³;
//! error: this is a sign for a cube, which is written pow(X, 3)
//!  --> sign_of_square.pov:3:15
//!   |
//! 3 | #declare C = A³;
//!   |               ^
