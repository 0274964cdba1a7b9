// SPDX-License-Identifier: GPL-3.0-or-later
// A word of the language as a name
#version 3.7;
#declare radius = 2;
#declare color = rgb 1;
