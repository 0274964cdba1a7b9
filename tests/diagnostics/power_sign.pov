// SPDX-License-Identifier: GPL-3.0-or-later
// x^2
#version 3.7;
#declare X = 3;
#declare A = X ^ 2;
