// SPDX-License-Identifier: GPL-3.0-or-later
// Normal and distance exchanged
#version 3.7;
plane { 0, y }
