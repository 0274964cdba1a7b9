#if (clock > 0) #declare Size = 1; #end
sphere { 0, Size }
//! error: nothing is declared as `Size`
//!  --> undef_behind_use.pov:2:13
//!   |
//! 1 | #if (clock > 0) #declare Size = 1; #end
//!   |                 ------------- declared only here, in a part that was not reached
//! 2 | sphere { 0, Size }
//!   |             ^^^^
#undef Size
//! warning[unknown-name]: nothing is declared as `Size`
//!  --> undef_behind_use.pov:3:8
//!   |
//! 3 | #undef Size
//!   |        ^^^^
