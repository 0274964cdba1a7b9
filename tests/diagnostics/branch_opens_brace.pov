// SPDX-License-Identifier: GPL-3.0-or-later
// A branch that opens what it does not close
#version 3.7;
#if (1)
    union {
#end
    sphere { 0, 1 }
}
