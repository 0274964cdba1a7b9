// SPDX-License-Identifier: GPL-3.0-or-later
// An expression where a function is wanted
#version 3.7;
isosurface { x*x + y*y - 1 }
//! error: `function` of `isosurface` must be a function, but it is a vector of 3
//!  --> isosurface_without_function.pov:4:14
//!   |
//! 4 | isosurface { x*x + y*y - 1 }
//!   |              ^^^^^^^^^^^^^ this is a vector of 3
//! help: isosurface { function [contained_by { ... }] [threshold n] [polarity n] [accuracy n] [max_gradient n] ... }   function: function
