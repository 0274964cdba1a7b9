// SPDX-License-Identifier: GPL-3.0-or-later
// A macro whose value is wanted and that has none
#version 3.7;
#macro Twice(A)
    #local B = 2 * A;
#end
#declare C = Twice(2);
