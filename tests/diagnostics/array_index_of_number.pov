// SPDX-License-Identifier: GPL-3.0-or-later
// A number has no elements
#version 3.7;
#declare A = 3;
#declare B = A[0];
