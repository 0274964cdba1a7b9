// SPDX-License-Identifier: GPL-3.0-or-later
// A string is no array
#version 3.7;
#declare S = "abc"; #declare C = S[0];
