// SPDX-License-Identifier: GPL-3.0-or-later
// One word written as two
#version 3.7;
camera { location <0,0,-5> look at 0 }
