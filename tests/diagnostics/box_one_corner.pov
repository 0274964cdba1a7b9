// SPDX-License-Identifier: GPL-3.0-or-later
// A corner is missing
#version 3.7;
box { <0, 0, 0> }
