// SPDX-License-Identifier: GPL-3.0-or-later
// Values of another kind than is wanted
#version 3.7;
#declare Red = rgb <1, 0, 0>;
#declare Wood = texture { pigment { rgb 0.5 } }
#declare Sizes = array[2] { 1, 2 }
sphere { Red, 1 }
sphere { 0, <1, 2, 3> }
sphere { 0, "one" }
sphere { 0, Sizes }
sphere { 0, 1 Wood }
sphere { 0, 1 pigment { <1, 0, 0> } }
sphere { 0, 1 translate Wood }
