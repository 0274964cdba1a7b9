// SPDX-License-Identifier: GPL-3.0-or-later
// A sky has pigments only
#version 3.7;
sky_sphere { texture { pigment { rgb 1 } } }
