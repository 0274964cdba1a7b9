// SPDX-License-Identifier: GPL-3.0-or-later
// A power as in other languages
#version 3.7;
#declare A = 2**3;
