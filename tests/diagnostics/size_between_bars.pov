#declare A = |-5|;
//! error: expected a value, but found `|`
//!  --> size_between_bars.pov:1:14
//!   |
//! 1 | #declare A = |-5|;
//!   |              ^
//! help: the size of a number without its sign is abs(X), of a vector vlength(V)
