// SPDX-License-Identifier: GPL-3.0-or-later
// A function as in other languages
#version 3.7;
function f(x) { return x*2 }
//! error: expected `}`, but found `x`
//!  --> function_as_in_c.pov:4:24
//!   |
//! 4 | function f(x) { return x*2 }
//!   |               -        ^
//!   |               |
//!   |               opened here
//! help: a function needs no `return`: function(X) { X*2 } gives what its expression gives
