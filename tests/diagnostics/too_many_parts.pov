#declare A = sphere { 0, 1 }
#for (I, 1, 40)
    #declare A = union { object { A } object { A translate x } }
#end
object { A }
//! error: with the parts of this object there are more than 25000 objects in the scene, which is the limit
//!  --> too_many_parts.pov:5:1
//!   |
//! 5 | object { A }
//!   | ^^^^^^^^^^^^
//! help: unions of unions grow fast; --limit-objects raises the limit
