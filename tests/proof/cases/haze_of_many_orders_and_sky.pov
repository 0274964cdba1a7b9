// SPDX-License-Identifier: GPL-3.0-or-later
// law chance, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 angle 30 }
sky_sphere { pigment { rgb 1 } emission 1/*light 0*/ luminaire/*luminaire*/ }
sphere { 0, 1 hollow pigment { rgb 1 transmit 1 } finish { diffuse 0 } interior { media { scattering { 1, 0.1 multiple } } } }
