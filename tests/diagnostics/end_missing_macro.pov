// SPDX-License-Identifier: GPL-3.0-or-later
// A macro without #end
#version 3.7;
#macro M(A)
    sphere { A, 1 }
M(0)
