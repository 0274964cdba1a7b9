// SPDX-License-Identifier: GPL-3.0-or-later
// An element that was never set
#version 3.7;
#declare A = array[3];
sphere { 0, A[1] }
