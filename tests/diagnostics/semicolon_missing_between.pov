// SPDX-License-Identifier: GPL-3.0-or-later
// A #declare runs into the next
#version 3.7;
#declare A = 1
#declare B = 2;
