#default texture { pigment { rgb 1 } }
//! error: expected `{`, but found `texture`
//!  --> default_without_braces.pov:1:10
//!   |
//! 1 | #default texture { pigment { rgb 1 } }
//!   |          ^^^^^^^
//! help: defaults stand in braces: #default { texture { ... } }
