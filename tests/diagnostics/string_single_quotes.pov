// SPDX-License-Identifier: GPL-3.0-or-later
// A string in '
#version 3.7;
#declare A = 'one';
