// SPDX-License-Identifier: GPL-3.0-or-later
// A vector in the wrong brackets
#version 3.7;
#declare A = (1, 2, 3);
sphere { A, 1 }
