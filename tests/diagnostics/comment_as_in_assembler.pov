; this is a comment
//! warning[semicolon]: this `;` has no effect
//!  --> comment_as_in_assembler.pov:1:1
//!   |
//! 1 | ; this is a comment
//!   | ^
//! help: `;` ends a #declare of numbers and nothing else
//! error: nothing is declared as `this`
//!  --> comment_as_in_assembler.pov:1:3
//!   |
//! 1 | ; this is a comment
//!   |   ^^^^
//! help: a comment begins with `//`
sphere { 0, 1 }
