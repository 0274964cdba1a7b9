#version 3.7;
#fopen Points "short_row.txt" read
#while (defined(Points))
    #read (Points, X, Y, Z)
//! warning[wrong-count]: this #read goes on in the next line of `short_row.txt`
//!  --> read_over_line_end.pov:4:26
//!   |
//! 4 |     #read (Points, X, Y, Z)
//!   |                          ^ this is in the next line
//!   |
//!  ::: short_row.txt:2:5
//!   |
//! 2 | 4, 5,
//!   |     - here a line ends
//! help: read_csv("...") reads tables, and reports short rows
    sphere { <X, Y, Z>, 1 }
#end
