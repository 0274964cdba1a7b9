#declare E = polynomial { 3, xyz(1, 0, 0) 1 }
//! error: expected `:`, but found `1`
//!  --> polynomial_colon.pov:1:43
//!   |
//! 1 | #declare E = polynomial { 3, xyz(1, 0, 0) 1 }
//!   |                                           ^
#declare F = polynomial { 3, xyz<1, 0, 0>: 1 }
//! error: expected `(` or `{`, but found `<1, 0, 0>`
//!  --> polynomial_colon.pov:2:33
//!   |
//! 2 | #declare F = polynomial { 3, xyz<1, 0, 0>: 1 }
//!   |                                 ^^^^^^^^^
