camera { location 0 target z }
//! error: `camera` has no word `target`
//!  --> target_of_camera.pov:1:21
//!   |
//! 1 | camera { location 0 target z }
//!   |                     ^^^^^^
//! help: did you mean `look_at`?
