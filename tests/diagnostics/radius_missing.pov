// SPDX-License-Identifier: GPL-3.0-or-later
// The radius is missing
#version 3.7;
sphere { <0, 1, 0> }
