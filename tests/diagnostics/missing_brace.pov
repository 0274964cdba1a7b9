// SPDX-License-Identifier: GPL-3.0-or-later
// A block that is not closed
#version 3.7;
union {
    sphere { <0, 0, 0>, 1 pigment { rgb 1 }
    box { 0, 1 }
}
plane { y, 0 }
