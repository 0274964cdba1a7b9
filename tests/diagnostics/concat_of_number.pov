// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers are no strings
#version 3.7;
#debug concat("a", 3)
