// SPDX-License-Identifier: GPL-3.0-or-later
// A function does not know itself yet
#version 3.7;
#declare F = function(n) { select(n, 0, n*F(n-1)) }
