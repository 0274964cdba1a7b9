// SPDX-License-Identifier: GPL-3.0-or-later
// A number in hexadecimal
#version 3.7;
#declare A = 0x10;
