// SPDX-License-Identifier: GPL-3.0-or-later
// Two commas
#version 3.7;
sphere { <0,, 1>, 1 }
