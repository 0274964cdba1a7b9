// SPDX-License-Identifier: GPL-3.0-or-later
// Indices begin with 0
#version 3.7;
#declare A = array[3] { 1, 2, 3 }
#for (I, 1, 3)
    sphere { A[I], 1 }
#end
