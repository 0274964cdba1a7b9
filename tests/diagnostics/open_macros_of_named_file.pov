#declare Name = "opening.inc";
#include Name
Begin(2) Finish()
//! error: nothing is declared as `Begin`
//!  --> open_macros_of_named_file.pov:3:1
//!   |
//! 3 | Begin(2) Finish()
//!   | ^^^^^
//! help: `Begin` leaves braces to other macros to close or open; such macros are found only where #include names the file by a plain string: #include "opening.inc"
//! error: nothing is declared as `Finish`
//!  --> open_macros_of_named_file.pov:3:10
//!   |
//! 3 | Begin(2) Finish()
//!   |          ^^^^^^
//! help: `Finish` leaves braces to other macros to close or open; such macros are found only where #include names the file by a plain string: #include "opening.inc"
