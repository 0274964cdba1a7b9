difference { box { 0, 1 } mesh { triangle { 0, x, y } } }
//! warning[no-effect]: this has no inside, so it cuts nothing off the others
//!  --> no_inside.pov:1:27
//!   |
//! 1 | difference { box { 0, 1 } mesh { triangle { 0, x, y } } }
//!   |                           ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
//! help: triangles have no inside; a mesh gets one by inside_vector
intersection { triangle { 0, x, y } box { 0, 1 } }
//! warning[no-effect]: this has no inside, so it leaves nothing of the others
//!  --> no_inside.pov:2:16
//!   |
//! 2 | intersection { triangle { 0, x, y } box { 0, 1 } }
//!   |                ^^^^^^^^^^^^^^^^^^^^
//! help: triangles have no inside; a mesh gets one by inside_vector
difference { triangle { 0, x, y } box { 0, 1 } }
