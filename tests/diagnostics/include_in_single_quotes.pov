#include 'parts.inc'
//! error: this is a single quote
//!  --> include_in_single_quotes.pov:1:10
//!   |
//! 1 | #include 'parts.inc'
//!   |          ^
//! help: write `"`
