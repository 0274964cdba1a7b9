// SPDX-License-Identifier: GPL-3.0-or-later
// Objects in objects without end
#version 3.7;
#macro Branch(Length)
    union {
        cylinder { 0, Length*y, 0.1 }
        object { Branch(Length*0.9) rotate 20*z }
        object { Branch(Length*0.9) rotate -20*z }
    }
#end
Branch(1)
