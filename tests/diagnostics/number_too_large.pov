// SPDX-License-Identifier: GPL-3.0-or-later
// A number beyond what there is
#version 3.7;
#declare A = 1e999;
sphere { 0, A }
