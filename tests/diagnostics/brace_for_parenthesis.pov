// SPDX-License-Identifier: GPL-3.0-or-later
// Braces around a condition
#version 3.7;
#if {1} sphere { 0, 1 } #end
