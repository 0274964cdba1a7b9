camera { position <0, 0, -5> }
//! error: `camera` has no word `position`
//!  --> words_of_other_programs.pov:1:10
//!   |
//! 1 | camera { position <0, 0, -5> }
//!   |          ^^^^^^^^
//! help: did you mean `location`?
camera { fov 30 }
//! error: `camera` has no word `fov`
//!  --> words_of_other_programs.pov:2:10
//!   |
//! 2 | camera { fov 30 }
//!   |          ^^^
//! help: did you mean `angle`?
