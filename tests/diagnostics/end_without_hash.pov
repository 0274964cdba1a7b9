// SPDX-License-Identifier: GPL-3.0-or-later
// `end` without its #
#version 3.7;
#for (I, 1, 3)
    sphere { I, 1 }
end
//! error: `end` needs a # before it
//!  --> end_without_hash.pov:6:1
//!   |
//! 6 | end
//!   | ^^^
//! help: write `#end`
