// SPDX-License-Identifier: GPL-3.0-or-later
// A string that does not end
#version 3.7;
#declare A = "one;
#declare B = "two";
