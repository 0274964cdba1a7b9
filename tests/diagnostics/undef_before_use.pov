#declare Size = 1;
#undef Size
sphere { 0, Size }
//! error: nothing is declared as `Size`
//!  --> undef_before_use.pov:3:13
//!   |
//! 3 | sphere { 0, Size }
//!   |             ^^^^
//! help: declare it first: #declare Size = ...;
