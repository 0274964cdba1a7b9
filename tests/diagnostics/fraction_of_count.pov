// SPDX-License-Identifier: GPL-3.0-or-later
// numbers with fractions where whole ones are wanted
#version 3.7;
camera { location -5*z }
light_source { -9*z, 1 area_light x, y, 3.5, 4 }
sphere { 0, 1 pigment { spiral1 2.5 turbulence 0.1 octaves 3.9999999 } }
prism { 0, 1, 4.5, <0, 0>, <1, 0>, <1, 1>, <0, 0> }
