// SPDX-License-Identifier: GPL-3.0-or-later
// #debug "a" "b"
#version 3.7;
#declare S = "abc";
#debug "S = " S "\n"
