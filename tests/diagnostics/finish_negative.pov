// SPDX-License-Identifier: GPL-3.0-or-later
// A value out of range
#version 3.7;
sphere { 0, 1 finish { roughness 0 } }
