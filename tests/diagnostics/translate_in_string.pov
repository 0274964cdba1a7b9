// SPDX-License-Identifier: GPL-3.0-or-later
// A string as a vector
#version 3.7;
sphere { 0, 1 translate "up" }
