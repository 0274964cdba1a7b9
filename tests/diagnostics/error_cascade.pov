// SPDX-License-Identifier: GPL-3.0-or-later
// One mistake in a macro is said once
#version 3.7;
#macro M(A)
    sphere { A, Nothing }
#end
#for (I, 1, 5)
    M(I)
#end
