// SPDX-License-Identifier: GPL-3.0-or-later
// return in a macro
#version 3.7;
#macro Twice(X) return X*2 #end
//! error: nothing is declared as `return`
//!  --> macro_returns.pov:4:17
//!   |
//! 4 | #macro Twice(X) return X*2 #end
//!   |                 ^^^^^^
//!   |
//!   = in macro `Twice`, called at macro_returns.pov:5:13
//! help: a macro needs no `return`: it gives what stands in it
sphere { 0, Twice(1) }
