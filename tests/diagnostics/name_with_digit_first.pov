// SPDX-License-Identifier: GPL-3.0-or-later
// A digit in front
#version 3.7;
#declare 2nd = 2;
