// SPDX-License-Identifier: GPL-3.0-or-later
// A component that has no such name
#version 3.7;
#declare V = <1, 2, 3>;
#declare A = V.w;
