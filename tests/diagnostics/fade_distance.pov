// SPDX-License-Identifier: GPL-3.0-or-later
// A length below 0
#version 3.7;
sphere { 0, 1 pigment { rgbt 1 } interior { fade_distance -2 fade_power 1 } }
