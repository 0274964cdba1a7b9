#declare I = 0;
#while (I < 3)
  sphere { I*x, 1 }
//! error: this scene makes more than 25000 objects, which is the limit
//!  --> endless_objects.pov:3:3
//!   |
//! 2 | #while (I < 3)
//!   |        ------- in this loop, which has run 12501 times
//! 3 |   sphere { I*x, 1 }
//!   |   ^^^^^^
//! help: something in a loop must make its condition false, or #break; --limit-objects raises the limit
  sphere { I*y, 1 }
#end
