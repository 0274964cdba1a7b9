// SPDX-License-Identifier: GPL-3.0-or-later
// A && B outside of parentheses
#version 3.7;
#declare B = true && false;
