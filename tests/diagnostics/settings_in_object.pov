// SPDX-License-Identifier: GPL-3.0-or-later
// A setting in an object
#version 3.7;
sphere { 0, 1 max_trace_level 3 }
