// SPDX-License-Identifier: GPL-3.0-or-later
// A `)` is missing
#version 3.7;
#declare A = (1 + 2 * (3 - 4);
#declare B = 2;
