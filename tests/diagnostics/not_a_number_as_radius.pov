#declare A = mod(5, 0);
sphere { 0, A }
//! error: `radius` of `sphere` must be finite, but it is not a number
//!  --> not_a_number_as_radius.pov:2:13
//!   |
//! 2 | sphere { 0, A }
//!   |             ^ this is not a number
//! help: sphere { centre, radius }   radius: number, whose sign does not count
