// SPDX-License-Identifier: GPL-3.0-or-later
// A finish in a pigment
#version 3.7;
sphere { 0, 1 pigment { rgb 1 finish { ambient 1 } } }
