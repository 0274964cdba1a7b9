// SPDX-License-Identifier: GPL-3.0-or-later
// Names that nobody has declared
#version 3.7;
#declare Radius = 2;
#declare Red = rgb <1, 0, 0>;
sphere { 0, Radios }
sphere { Centre, 1 }
sphere { 0, Radius*Scaling }
sphere { 0, 1 pigment { Rde } }
object { Lamp translate x }
