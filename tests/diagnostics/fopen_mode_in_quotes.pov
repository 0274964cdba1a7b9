#fopen F "numbers.txt" "r"
//! error: expected a name, but found `"r"`
//!  --> fopen_mode_in_quotes.pov:1:24
//!   |
//! 1 | #fopen F "numbers.txt" "r"
//!   |                        ^^^
//! help: what the file is for comes last: #fopen File "data.txt" read, or write, or append
#read (F, A)
