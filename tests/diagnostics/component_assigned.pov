// SPDX-License-Identifier: GPL-3.0-or-later
// A component cannot be set
#version 3.7;
#declare V = <1, 2, 3>;
#declare V.x = 2;
