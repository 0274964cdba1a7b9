"hello"
//! error: a string has no place in a scene
//!  --> string_alone.pov:1:1
//!   |
//! 1 | "hello"
//!   | ^^^^^^^
//! help: #debug "...\n" prints a string
