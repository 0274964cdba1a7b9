// SPDX-License-Identifier: GPL-3.0-or-later
// A macro that never ends
#version 3.7;
#macro Branch(Length)
    sphere { Length*y, 0.1 }
    Branch(Length + 1)
#end
Branch(1)
