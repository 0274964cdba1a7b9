#declare D = dictionary { ["a"]: 1 };
//! error: `:` does not fit here
//!  --> dictionary.pov:1:32
//!   |
//! 1 | #declare D = dictionary { ["a"]: 1 };
//!   |                                ^
//! help: dictionaries are not available in this version
