// SPDX-License-Identifier: GPL-3.0-or-later
// Characters beyond the end
#version 3.7;
#declare A = substr("abc", 2, 5);
