// SPDX-License-Identifier: GPL-3.0-or-later
// A number without its point
#version 3.7;
#declare S = spline { linear_spline 0 }
