// SPDX-License-Identifier: GPL-3.0-or-later
// A loop as in other languages
#version 3.7;
#for I = 1 to 10
