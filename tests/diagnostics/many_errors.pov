// SPDX-License-Identifier: GPL-3.0-or-later
// More mistakes than are shown
#version 3.7;
#for (I, 1, 1)
    sphere { 0, Name_0 }
//! error: nothing is declared as `Name_0`
//!  --> many_errors.pov:5:17
//!   |
//! 5 |     sphere { 0, Name_0 }
//!   |                 ^^^^^^
//! help: declare it first: #declare Name_0 = ...;
    sphere { 1, Name_1 }
//! error: nothing is declared as `Name_1`
//!  --> many_errors.pov:6:17
//!   |
//! 6 |     sphere { 1, Name_1 }
//!   |                 ^^^^^^
//! help: declare it first: #declare Name_1 = ...;
    sphere { 2, Name_2 }
//! error: nothing is declared as `Name_2`
//!  --> many_errors.pov:7:17
//!   |
//! 7 |     sphere { 2, Name_2 }
//!   |                 ^^^^^^
//! help: declare it first: #declare Name_2 = ...;
    sphere { 3, Name_3 }
//! error: nothing is declared as `Name_3`
//!  --> many_errors.pov:8:17
//!   |
//! 8 |     sphere { 3, Name_3 }
//!   |                 ^^^^^^
//! help: declare it first: #declare Name_3 = ...;
    sphere { 4, Name_4 }
//! error: nothing is declared as `Name_4`
//!  --> many_errors.pov:9:17
//!   |
//! 9 |     sphere { 4, Name_4 }
//!   |                 ^^^^^^
//! help: declare it first: #declare Name_4 = ...;
    sphere { 5, Name_5 }
//! error: nothing is declared as `Name_5`
//!   --> many_errors.pov:10:17
//!    |
//! 10 |     sphere { 5, Name_5 }
//!    |                 ^^^^^^
//! help: declare it first: #declare Name_5 = ...;
    sphere { 6, Name_6 }
//! error: nothing is declared as `Name_6`
//!   --> many_errors.pov:11:17
//!    |
//! 11 |     sphere { 6, Name_6 }
//!    |                 ^^^^^^
//! help: declare it first: #declare Name_6 = ...;
    sphere { 7, Name_7 }
//! error: nothing is declared as `Name_7`
//!   --> many_errors.pov:12:17
//!    |
//! 12 |     sphere { 7, Name_7 }
//!    |                 ^^^^^^
//! help: declare it first: #declare Name_7 = ...;
    sphere { 8, Name_8 }
//! error: nothing is declared as `Name_8`
//!   --> many_errors.pov:13:17
//!    |
//! 13 |     sphere { 8, Name_8 }
//!    |                 ^^^^^^
//! help: declare it first: #declare Name_8 = ...;
    sphere { 9, Name_9 }
//! error: nothing is declared as `Name_9`
//!   --> many_errors.pov:14:17
//!    |
//! 14 |     sphere { 9, Name_9 }
//!    |                 ^^^^^^
//! help: declare it first: #declare Name_9 = ...;
    sphere { 10, Name_10 }
//! error: nothing is declared as `Name_10`
//!   --> many_errors.pov:15:18
//!    |
//! 15 |     sphere { 10, Name_10 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_10 = ...;
    sphere { 11, Name_11 }
//! error: nothing is declared as `Name_11`
//!   --> many_errors.pov:16:18
//!    |
//! 16 |     sphere { 11, Name_11 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_11 = ...;
    sphere { 12, Name_12 }
//! error: nothing is declared as `Name_12`
//!   --> many_errors.pov:17:18
//!    |
//! 17 |     sphere { 12, Name_12 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_12 = ...;
    sphere { 13, Name_13 }
//! error: nothing is declared as `Name_13`
//!   --> many_errors.pov:18:18
//!    |
//! 18 |     sphere { 13, Name_13 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_13 = ...;
    sphere { 14, Name_14 }
//! error: nothing is declared as `Name_14`
//!   --> many_errors.pov:19:18
//!    |
//! 19 |     sphere { 14, Name_14 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_14 = ...;
    sphere { 15, Name_15 }
//! error: nothing is declared as `Name_15`
//!   --> many_errors.pov:20:18
//!    |
//! 20 |     sphere { 15, Name_15 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_15 = ...;
    sphere { 16, Name_16 }
//! error: nothing is declared as `Name_16`
//!   --> many_errors.pov:21:18
//!    |
//! 21 |     sphere { 16, Name_16 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_16 = ...;
    sphere { 17, Name_17 }
//! error: nothing is declared as `Name_17`
//!   --> many_errors.pov:22:18
//!    |
//! 22 |     sphere { 17, Name_17 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_17 = ...;
    sphere { 18, Name_18 }
//! error: nothing is declared as `Name_18`
//!   --> many_errors.pov:23:18
//!    |
//! 23 |     sphere { 18, Name_18 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_18 = ...;
    sphere { 19, Name_19 }
//! error: nothing is declared as `Name_19`
//!   --> many_errors.pov:24:18
//!    |
//! 24 |     sphere { 19, Name_19 }
//!    |                  ^^^^^^^
//! help: declare it first: #declare Name_19 = ...;
    sphere { 20, Name_20 }
    sphere { 21, Name_21 }
    sphere { 22, Name_22 }
    sphere { 23, Name_23 }
    sphere { 24, Name_24 }
#end
