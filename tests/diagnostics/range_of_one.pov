#declare A = 2;
#switch (A)
    #range (2) sphere { 0, 1 } #break
//! error: expected `,`, but found `)`
//!  --> range_of_one.pov:3:14
//!   |
//! 3 |     #range (2) sphere { 0, 1 } #break
//!   |              ^
//! help: a range has two ends: #range (1, 2)
#end
