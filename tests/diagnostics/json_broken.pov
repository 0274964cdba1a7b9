#version 3.7;
#declare Set = read_json("broken.json");
//! error: line 3 of `broken.json` is no JSON from here on
//!  --> broken.json:3:13
//!   |
//! 3 |     { "at": }
//!   |             ^
//!   |
//!  ::: json_broken.pov:2:26
//!   |
//! 2 | #declare Set = read_json("broken.json");
//!   |                          ------------- read here
