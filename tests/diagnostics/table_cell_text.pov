#version 3.7;
camera { location <0, 1, -5> look_at 0 }
#declare Height = "two and a half, or perhaps a little more than that";
light_source { <1, Height, 0.5>, rgb 1 }
//! error: a component of a vector is a number, but this is the string "two and a half, or perhaps a little more..."
//!  --> table_cell_text.pov:4:20
//!   |
//! 4 | light_source { <1, Height, 0.5>, rgb 1 }
//!   |                    ^^^^^^
