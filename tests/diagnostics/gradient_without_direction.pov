sphere { 0, 1 pigment { gradient } }
//! error: `gradient` needs `direction`
//!  --> gradient_without_direction.pov:1:25
//!   |
//! 1 | sphere { 0, 1 pigment { gradient } }
//!   |                         ^^^^^^^^
//! help: pigment { gradient direction }
