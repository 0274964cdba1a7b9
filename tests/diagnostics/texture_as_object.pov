// SPDX-License-Identifier: GPL-3.0-or-later
// A texture in the scene
#version 3.7;
#declare T = texture { pigment { rgb 1 } }
T
