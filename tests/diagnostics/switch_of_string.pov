// SPDX-License-Identifier: GPL-3.0-or-later
// #switch of a string
#version 3.7;
#switch ("a")
    #case ("a")
        sphere { 0, 1 }
#end
