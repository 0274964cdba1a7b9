// SPDX-License-Identifier: GPL-3.0-or-later
// Six components
#version 3.7;
#declare V = <1, 2, 3, 4, 5, 6>;
