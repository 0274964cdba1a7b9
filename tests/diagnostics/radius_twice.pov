// SPDX-License-Identifier: GPL-3.0-or-later
// A value too many
#version 3.7;
sphere { <0, 1, 0>, 1, 2 }
