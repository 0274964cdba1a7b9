// SPDX-License-Identifier: GPL-3.0-or-later
// Names that their library does not want to be used any more
#version 3.7;
#declare deprecated "Old is replaced by New" Old = 3;
#declare deprecated once Older = 4;
#macro deprecated_macro() 1 #end
camera { location <0, 0, -9> look_at 0 }
light_source { <9, 9, -9>, 1 }
sphere { 0, Old }
//! warning[deprecated]: Old is replaced by New
//!  --> declared_deprecated.pov:9:13
//!   |
//! 9 | sphere { 0, Old }
//!   |             ^^^
#for (I, 1, 3)
    sphere { I * x, Old + I }
//! warning[deprecated]: Old is replaced by New
//!   --> declared_deprecated.pov:11:21
//!    |
//! 11 |     sphere { I * x, Old + I }
//!    |                     ^^^
#end
sphere { Older * x, Older }
//! warning[deprecated]: `Older` is not to be used any more
//!   --> declared_deprecated.pov:13:10
//!    |
//! 13 | sphere { Older * x, Older }
//!    |          ^^^^^
