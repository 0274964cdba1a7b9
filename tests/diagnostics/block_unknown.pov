// SPDX-License-Identifier: GPL-3.0-or-later
// A block of another language
#version 3.7;
cube { 0, 1 }
