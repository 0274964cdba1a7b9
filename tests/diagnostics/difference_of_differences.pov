#declare A = sphere { 0, 1 }
#for (I, 1, 40)
    #declare A = difference { object { A } object { A translate x } }
//! error: this object has more than 25000 parts, which is the limit of objects
//!  --> difference_of_differences.pov:3:18
//!   |
//! 2 | #for (I, 1, 40)
//!   |          ----- in this loop, which has run 15 times
//! 3 |     #declare A = difference { object { A } object { A translate x } }
//!   |                  ^^^^^^^^^^
//! help: objects of objects grow fast; --limit-objects raises the limit
#end
