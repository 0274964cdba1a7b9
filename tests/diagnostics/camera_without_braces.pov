// SPDX-License-Identifier: GPL-3.0-or-later
// What follows a word without braces is not told of again
#version 3.7;
camera location <0,0,-5> look_at 0
