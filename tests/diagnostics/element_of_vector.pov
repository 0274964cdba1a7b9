// SPDX-License-Identifier: GPL-3.0-or-later
// V[0]
#version 3.7;
#declare V = <1, 2, 3>;
#declare M = V[0];
