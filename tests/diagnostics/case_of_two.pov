#declare A = 2;
#switch (A)
    #case (1, 2) sphere { 0, 1 } #break
//! error: expected `)`, but found `,`
//!  --> case_of_two.pov:3:13
//!   |
//! 3 |     #case (1, 2) sphere { 0, 1 } #break
//!   |           - ^
//!   |           |
//!   |           opened here
//! help: each value has its own case, and a range is #range (1, 2)
#end
