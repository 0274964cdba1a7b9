isosurface { function { x*x - 1 contained_by { box { -1, 1 } } }
//! error: expected `}`, but found `contained_by`
//!  --> function_not_closed.pov:1:33
//!   |
//! 1 | isosurface { function { x*x - 1 contained_by { box { -1, 1 } } }
//!   |                       -         ^^^^^^^^^^^^
//!   |                       |
//!   |                       opened here
//! help: add the missing `}`
