// SPDX-License-Identifier: GPL-3.0-or-later
// a colour of a web page
#version 3.7;
sphere { 0, 1 pigment { #ff8000 } }
