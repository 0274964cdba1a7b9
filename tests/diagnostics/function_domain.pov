// SPDX-License-Identifier: GPL-3.0-or-later
// Not defined for these
#version 3.7;
#declare A = sqrt(-1);
#declare B = ln(0);
