#declare A = sphere { 0, 1 } - box { 0, 1 };
//! error: expected a value, but found `box`
//!  --> objects_subtracted.pov:1:32
//!   |
//! 1 | #declare A = sphere { 0, 1 } - box { 0, 1 };
//!   |                                ^^^
//! help: objects are joined by blocks: difference { A B }, union { A B }
