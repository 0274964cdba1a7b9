sphere { 0, 1 halo { emitting } hollow }
//! error: `sphere` has no word `halo`
//!  --> halo.pov:1:15
//!   |
//! 1 | sphere { 0, 1 halo { emitting } hollow }
//!   |               ^^^^
//! help: POV-Ray 3.1 replaced it by `media`: hollow interior { media { ... } }
atmosphere { type 1 }
//! error: a scene has no word `atmosphere`
//!  --> halo.pov:2:1
//!   |
//! 2 | atmosphere { type 1 }
//!   | ^^^^^^^^^^
//! help: POV-Ray 3.1 replaced it by `media`: media { scattering { ... } }
