// SPDX-License-Identifier: GPL-3.0-or-later
// A space of another kind
#version 3.7;
sphere { <0, 1, 0>, 1 }
