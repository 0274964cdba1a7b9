text {
  ttf "none.ttf" "Hello" 1, 0
//! error: there is no file `none.ttf`
//!  --> file_of_block_missing.pov:2:7
//!   |
//! 2 |   ttf "none.ttf" "Hello" 1, 0
//!   |       ^^^^^^^^^^
//!   |
//!   = looked in the current directory
}
height_field {
  png "none.png"
//! error: there is no file `none.png`
//!  --> file_of_block_missing.pov:5:7
//!   |
//! 5 |   png "none.png"
//!   |       ^^^^^^^^^^
//!   |
//!   = looked in the current directory
}
sphere { 0, 1
  pigment { image_map { png "none.png" } } }
//! error: there is no file `none.png`
//!  --> file_of_block_missing.pov:8:29
//!   |
//! 8 |   pigment { image_map { png "none.png" } } }
//!   |                             ^^^^^^^^^^
//!   |
//!   = looked in the current directory
