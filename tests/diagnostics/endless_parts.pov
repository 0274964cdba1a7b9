union {
  #for (I, 1, 2)
    #while (1)
      box { -1, 1 }
      box { 0, 2 }
//! error: this scene makes more than 25000 objects, which is the limit
//!  --> endless_parts.pov:5:7
//!   |
//! 3 |     #while (1)
//!   |            --- in this loop, which has run 12500 times
//! 4 |       box { -1, 1 }
//! 5 |       box { 0, 2 }
//!   |       ^^^
//! help: something in a loop must make its condition false, or #break; --limit-objects raises the limit
    #end
  #end
}
