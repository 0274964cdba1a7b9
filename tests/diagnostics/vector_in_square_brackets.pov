// SPDX-License-Identifier: GPL-3.0-or-later
// A vector in the brackets of another language
#version 3.7;
sphere { [0,0,0], 1 }
