// SPDX-License-Identifier: GPL-3.0-or-later
// #declare A = { 1, 2, 3 };
#version 3.7;
#declare A = { 1, 2, 3 };
