// SPDX-License-Identifier: GPL-3.0-or-later
// A comment that does not end
#version 3.7;
sphere { 0, 1 }
/* from here on
box { 0, 1 }
