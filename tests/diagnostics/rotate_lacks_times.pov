// SPDX-License-Identifier: GPL-3.0-or-later
// rotate y 45
#version 3.7;
sphere { 0, 1 rotate y 45 }
