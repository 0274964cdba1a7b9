#declare S = "0123456789";
#while (1)
    #declare S = concat(S, S);
//! error: this string has more than 1000 bytes, which is the limit
//!  --> string_too_long.pov:3:18
//!   |
//! 2 | #while (1)
//!   |        --- in this loop, which has run 7 times
//! 3 |     #declare S = concat(S, S);
//!   |                  ^^^^^^^^^^^^
//! help: --limit-text, in megabytes, raises it
#end
