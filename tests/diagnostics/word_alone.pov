// SPDX-License-Identifier: GPL-3.0-or-later
// A word without its block
#version 3.7;
sphere
box { 0, 1 }
