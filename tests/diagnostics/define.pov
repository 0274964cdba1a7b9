// SPDX-License-Identifier: GPL-3.0-or-later
// A directive of another language
#version 3.7;
#define A 3
