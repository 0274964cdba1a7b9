def Ball(R):
//! error: `:` does not fit here
//!  --> macro_as_in_python.pov:1:12
//!   |
//! 1 | def Ball(R):
//!   |            ^
//! help: a macro is written #macro Name(A, B) ... #end
    sphere { 0, R }
Ball(3)
