mesh {
    sphere { 0, 1 }
    box { 0, 2 }
//! error: a `mesh` is made of one object or hull, and this is a second
//!  --> mesh_of_two.pov:3:5
//!   |
//! 3 |     box { 0, 2 }
//!   |     ^^^
//! help: mesh { union { ... } } makes one of several
}
