// SPDX-License-Identifier: GPL-3.0-or-later
// i += 1
#version 3.7;
#declare I = 0;
#declare I += 1;
