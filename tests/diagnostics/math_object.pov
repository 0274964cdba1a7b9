// SPDX-License-Identifier: GPL-3.0-or-later
// Functions belong to no object
#version 3.7;
#declare A = Math.sin(3);
