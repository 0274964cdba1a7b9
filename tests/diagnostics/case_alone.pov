// SPDX-License-Identifier: GPL-3.0-or-later
// A #case outside of #switch
#version 3.7;
#case (1)
    sphere { 0, 1 }
