#fopen F "out.txt" write
#write F, "a"
//! error: expected `(`, but found `F`
//!  --> write_without_parentheses.pov:2:8
//!   |
//! 2 | #write F, "a"
//!   |        ^
//! help: what is written stands in parentheses: #write (File, A, "\n")
#fclose F
