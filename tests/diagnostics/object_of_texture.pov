// SPDX-License-Identifier: GPL-3.0-or-later
// object { } of a texture
#version 3.7;
#declare T = texture { pigment { rgb 1 } }
object { T }
