// SPDX-License-Identifier: GPL-3.0-or-later
// Too few and too many values, and a vector that is too long
#version 3.7;
cylinder { <0, 0, 0>, 0.5 }
sphere { <0, 0, 0>, 1, 2 }
sphere { <1, 2, 3, 4>, 1 }
sphere { 0, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1> }
