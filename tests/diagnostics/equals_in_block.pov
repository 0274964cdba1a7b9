// SPDX-License-Identifier: GPL-3.0-or-later
// A word of a block with an equals sign
#version 3.7;
sphere { 0, 1 finish { ambient = 1 } }
