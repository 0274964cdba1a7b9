sphere { 0, 1 rotate 45 y }
//! error: this value belongs to nothing
//!  --> other_habits.pov:1:25
//!   |
//! 1 | sphere { 0, 1 rotate 45 y }
//!   |                         ^
//! help: write `rotate y*45`
sphere { 0, 1 rotate y 45 }
//! error: this value belongs to nothing
//!  --> other_habits.pov:2:24
//!   |
//! 2 | sphere { 0, 1 rotate y 45 }
//!   |                        ^^
//! help: write `rotate y*45`
#declare T = texture { pigment { rgb 1 } }
sphere { 0, 1 texture T }
//! error: what belongs to `texture` stands in braces
//!  --> other_habits.pov:4:15
//!   |
//! 4 | sphere { 0, 1 texture T }
//!   |               ^^^^^^^
//! help: write `texture { T }`
#declare C = rgba <1, 0, 0, 0.5>;
//! error: nothing is declared as `rgba`
//!  --> other_habits.pov:5:14
//!   |
//! 5 | #declare C = rgba <1, 0, 0, 0.5>;
//!   |              ^^^^
//! help: write `rgbt <red, green, blue, transmit>`, with 1 - alpha as transmit
//! error: a vector of 4 has no place in a scene
//!  --> other_habits.pov:5:19
//!   |
//! 5 | #declare C = rgba <1, 0, 0, 0.5>;
//!   |                   ^^^^^^^^^^^^^^
