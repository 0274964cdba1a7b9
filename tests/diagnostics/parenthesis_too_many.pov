// SPDX-License-Identifier: GPL-3.0-or-later
// A `)` too many
#version 3.7;
#declare A = (1 + 2));
