// SPDX-License-Identifier: GPL-3.0-or-later
// return in a macro
#version 3.7;
#macro Twice(X) return X*2 #end
sphere { 0, Twice(1) }
