// SPDX-License-Identifier: GPL-3.0-or-later
// A block of the scene with a letter too few
#version 3.7;
sphre { 0, 1 }
sphere { 0, 1 }
