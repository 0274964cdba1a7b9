sphere { 0, 1 pigment { rgb 1 transparency 0.5 } }
//! error: `pigment` has no word `transparency`
//!  --> pigment_transparency.pov:1:31
//!   |
//! 1 | sphere { 0, 1 pigment { rgb 1 transparency 0.5 } }
//!   |                               ^^^^^^^^^^^^
//! help: what is half clear has a colour like rgbt <1, 0, 0, 0.5>
