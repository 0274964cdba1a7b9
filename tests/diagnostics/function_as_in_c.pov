// SPDX-License-Identifier: GPL-3.0-or-later
// A function as in other languages
#version 3.7;
function f(x) { return x*2 }
