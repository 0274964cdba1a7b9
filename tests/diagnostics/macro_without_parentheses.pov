// SPDX-License-Identifier: GPL-3.0-or-later
// A macro without a list of parameters
#version 3.7;
#macro Lamp sphere { 0, 1 } #end
