#version 3.7;
#macro Open(R) union { sphere { 0, R } #end
#macro Close() } #end
Open(1, 2) box { 0, 1 } Close()
//! error: macro `Open` takes 1 argument, but here are 2
//!  --> macro_opens_brace_arguments.pov:4:1
//!   |
//! 2 | #macro Open(R) union { sphere { 0, R } #end
//!   | ------ defined here
//! 3 | #macro Close() } #end
//! 4 | Open(1, 2) box { 0, 1 } Close()
//!   | ^^^^
