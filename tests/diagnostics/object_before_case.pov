#declare A = 2;
#switch (A)
    sphere { 0, 1 }
//! error: only directives can stand between a #switch and its first #case
//!  --> object_before_case.pov:3:5
//!   |
//! 3 |     sphere { 0, 1 }
//!   |     ^^^^^^^^^^^^^^^
    #case (2) box { 0, 1 } #break
#end
