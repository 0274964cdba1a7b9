// SPDX-License-Identifier: GPL-3.0-or-later
// Two objects where one is wanted
#version 3.7;
object { sphere { 0, 1 } box { 0, 1 } }
