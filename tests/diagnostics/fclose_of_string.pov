#fopen F "out.txt" write
#fclose "out.txt"
//! error: expected a name, but found `"out.txt"`
//!  --> fclose_of_string.pov:2:9
//!   |
//! 2 | #fclose "out.txt"
//!   |         ^^^^^^^^^
//! help: the name that #fopen gave the file: #fclose File
