#version 3.7;
#for (I, 1, 60)
    #declare A = asin(1 + I);
//! warning[domain]: the argument is 2; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 3; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 4; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 5; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 6; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 7; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 8; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 9; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 10; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 11; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 12; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 13; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 14; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 15; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 16; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 17; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 18; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 19; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 20; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
//! warning[domain]: the argument is 21; outside -1 to 1 the nearer end is taken
//!  --> many_warnings.pov:3:23
//!   |
//! 3 |     #declare A = asin(1 + I);
//!   |                       ^^^^^
#end
//! warning[domain]: and 40 more of this kind
//! help: --warn no-domain switches all of them off
