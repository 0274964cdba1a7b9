// SPDX-License-Identifier: GPL-3.0-or-later
// Strings are not added
#version 3.7;
#declare A = "one" + "two";
