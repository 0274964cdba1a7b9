// SPDX-License-Identifier: GPL-3.0-or-later
// A plane without direction
#version 3.7;
plane { 0, 1 }
