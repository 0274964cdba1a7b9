// SPDX-License-Identifier: GPL-3.0-or-later
// A block without its braces
#version 3.7;
background rgb 1
