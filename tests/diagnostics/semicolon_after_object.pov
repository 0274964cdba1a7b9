// SPDX-License-Identifier: GPL-3.0-or-later
// A `;` as in C
#version 3.7;
sphere { 0, 1 };
box { 0, 1 };
