// SPDX-License-Identifier: GPL-3.0-or-later
// A transformation with two values
#version 3.7;
sphere { 0, 1 rotate 45, y }
