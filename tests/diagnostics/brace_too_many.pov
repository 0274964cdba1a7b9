// SPDX-License-Identifier: GPL-3.0-or-later
// A `}` too many
#version 3.7;
sphere { 0, 1 } }
box { 0, 1 }
