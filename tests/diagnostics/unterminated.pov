// SPDX-License-Identifier: GPL-3.0-or-later
// A string without its end
#version 3.7;
#debug "hello
sphere { 0, 1 }
