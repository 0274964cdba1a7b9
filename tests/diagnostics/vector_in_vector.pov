// SPDX-License-Identifier: GPL-3.0-or-later
// A vector as a component
#version 3.7;
#declare A = <1, 2, 3>;
sphere { <A, 0, 0>, 1 }
