#for (I, 0, 3)
    #if (I = 2) #declare Last = I; #end
    sphere { Last*x, 1 }
//! error: nothing is declared as `Last`
//!  --> declared_in_another_branch.pov:3:14
//!   |
//! 2 |     #if (I = 2) #declare Last = I; #end
//!   |                 ------------- declared only here, in a part that was not reached
//! 3 |     sphere { Last*x, 1 }
//!   |              ^^^^
#end
