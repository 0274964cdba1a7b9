#default { sphere { 0, 1 } }
//! error: `sphere` has no place in `#default`
//!  --> default_of_object.pov:1:12
//!   |
//! 1 | #default { sphere { 0, 1 } }
//!   |            ^^^^^^
//! help: #default { texture { ... } }, or pigment, normal, finish, camera
