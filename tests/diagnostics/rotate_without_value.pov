// SPDX-License-Identifier: GPL-3.0-or-later
// A transformation without value
#version 3.7;
sphere { 0, 1 rotate }
