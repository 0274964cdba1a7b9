camera { user_defined location { function(u, v) { 0 } } }
//! error: `location` needs `y` and `z`
//!  --> camera_of_functions.pov:1:23
//!   |
//! 1 | camera { user_defined location { function(u, v) { 0 } } }
//!   |                       ^^^^^^^^
//! help: location { function { ... } function { ... } function { ... } }
