sphere { 0, 1 translate 1, 2, 3 }
//! error: `translate` takes one vector, and a vector stands in `< >`
//!  --> vector_without_brackets.pov:1:28
//!   |
//! 1 | sphere { 0, 1 translate 1, 2, 3 }
//!   |                            ^
//! help: write `translate <1, 2, 3>`
sphere { 0, 1 scale 1, -2 1 pigment { rgb 1 } }
//! error: `scale` takes one vector, and a vector stands in `< >`
//!  --> vector_without_brackets.pov:2:24
//!   |
//! 2 | sphere { 0, 1 scale 1, -2 1 pigment { rgb 1 } }
//!   |                        ^^
//! help: write `scale <1, -2, 1>`
#declare A = 45;
sphere { 0, 1 rotate A, 0, 0 }
//! error: `rotate` takes one vector, and a vector stands in `< >`
//!  --> vector_without_brackets.pov:4:25
//!   |
//! 4 | sphere { 0, 1 rotate A, 0, 0 }
//!   |                         ^
//! help: write `rotate <x, y, z>`
camera { location 0,0,-5 look_at 0,0,0 }
//! error: `location` takes one vector, and a vector stands in `< >`
//!  --> vector_without_brackets.pov:5:21
//!   |
//! 5 | camera { location 0,0,-5 look_at 0,0,0 }
//!   |                     ^
//! help: write `location <0, 0, -5>`
sphere { 0, 0, 0, 1 }
//! error: `sphere` takes 2 values, and a vector among them stands in `< >`
//!  --> vector_without_brackets.pov:6:16
//!   |
//! 6 | sphere { 0, 0, 0, 1 }
//!   |                ^
//! help: write `sphere { <0, 0, 0>, 1 }`
cylinder { 0, 0, 0, A, 1, 0, A }
//! error: `cylinder` takes 3 values, and a vector among them stands in `< >`
//!  --> vector_without_brackets.pov:7:21
//!   |
//! 7 | cylinder { 0, 0, 0, A, 1, 0, A }
//!   |                     ^
//! help: write `cylinder { <0, 0, 0>, <x, y, z>, radius }`
plane { 0, 1, 0, 0 }
//! error: `plane` takes 2 values, and a vector among them stands in `< >`
//!  --> vector_without_brackets.pov:8:15
//!   |
//! 8 | plane { 0, 1, 0, 0 }
//!   |               ^
//! help: write `plane { <0, 1, 0>, 0 }`
torus { 1, 0.5, 3 }
//! error: `torus` takes 2 values, but here is one more
//!  --> vector_without_brackets.pov:9:17
//!   |
//! 9 | torus { 1, 0.5, 3 }
//!   |                 ^
//! help: torus { major, minor [union] [merge] [difference] [intersection] }
