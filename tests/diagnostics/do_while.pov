#declare I = 0;
#do
//! error: there is no directive `#do`
//!  --> do_while.pov:2:1
//!   |
//! 2 | #do
//!   | ^^^
//! help: a loop is written #while (A) ... #end
    #declare I = I + 1;
#while (I < 10)
//! error: `#while` has no `#end`
//!  --> do_while.pov:4:1
//!   |
//! 4 | #while (I < 10)
//!   | ^^^^^^
