// SPDX-License-Identifier: GPL-3.0-or-later
// Things in the wrong place
#version 3.7;
finish { ambient 1 }
sphere { 0, 1 location x }
union { sphere { 0, 1 } translate x box { 0, 1 } }
object { sphere { 0, 1 } sphere { x, 1 } }
camera { location -z orthographic }
sphere { 0, 1 pigment { rgb 1 rgb 0 } }
5
