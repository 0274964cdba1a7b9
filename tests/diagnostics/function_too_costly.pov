#declare A = function(x) { x + 1 }
#declare B = function(x) { sum(i, 1, 3, A(i)) + A(x) + A(-x) }
#declare C = function(x) { B(x) + B(x + 1) + B(x + 2) + B(x + 3) + B(x + 4) + B(x + 5) + B(x + 6) }
#declare D = function(x) { C(x) + C(x + 1) + C(x + 2) + C(x + 3) + C(x + 4) + C(x + 5) + C(x + 6) }
#declare E = function(x) { D(x) + D(x + 1) + D(x + 2) + D(x + 3) + D(x + 4) + D(x + 5) + D(x + 6) }
#declare F = function(x) { E(x) + E(x + 1) + E(x + 2) + E(x + 3) + E(x + 4) + E(x + 5) + E(x + 6) }
#declare G = function(x) { F(x) + F(x + 1) + F(x + 2) + F(x + 3) + F(x + 4) + F(x + 5) + F(x + 6) }
#declare H = function(x) { G(x) + G(x + 1) + G(x + 2) + G(x + 3) + G(x + 4) + G(x + 5) + G(x + 6) }
#declare I = function(x) { H(x) + H(x + 1) + H(x + 2) + H(x + 3) + H(x + 4) + H(x + 5) + H(x + 6) }
//! error: a call of this function can take more than 10000000 steps, which is the limit
//!  --> function_too_costly.pov:9:14
//!   |
//! 9 | #declare I = function(x) { H(x) + H(x + 1) + H(x + 2) + H(x + 3) + H(x + 4) + H(x + 5) + H(x + 6) }
//!   |              ^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^
//! help: functions that call others twice grow fast: compute a part beforehand, or pass it as an argument; --limit-function raises the limit
