print("hello")
//! error: nothing is declared as `print`
//!  --> print_as_in_python.pov:1:1
//!   |
//! 1 | print("hello")
//!   | ^^^^^
//! help: #debug "...\n" prints a string
#declare A = None;
//! error: nothing is declared as `None`
//!  --> print_as_in_python.pov:2:14
//!   |
//! 2 | #declare A = None;
//!   |              ^^^^
//! help: a name that is not declared has no value: #ifdef (Name)
