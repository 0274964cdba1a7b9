// SPDX-License-Identifier: GPL-3.0-or-later
// A function that does not exist
#version 3.7;
#declare A = sine(1);
