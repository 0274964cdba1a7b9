light_source { <0, 10, 0>, rgb 1 brightness 2 }
//! error: `brightness` has no place in `light_source`
//!  --> light_brightness.pov:1:34
//!   |
//! 1 | light_source { <0, 10, 0>, rgb 1 brightness 2 }
//!   |                                  ^^^^^^^^^^
//!   |
//!   = it belongs in `sky_luminance`, `radiosity`
//! help: light_source { location[, colour] [spotlight] [cylinder] [parallel] [point_at v] [radius n] [falloff n] ... }
