#fopen F "numbers.txt"
#read (F, A)
//! error: expected a name, but found `#read`
//!  --> fopen_without_mode.pov:2:1
//!   |
//! 2 | #read (F, A)
//!   | ^^^^^
//! help: what the file is for comes last: #fopen File "data.txt" read, or write, or append
