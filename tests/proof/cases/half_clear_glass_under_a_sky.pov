// SPDX-License-Identifier: GPL-3.0-or-later
// law furnace, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 max_trace_level 40 integrator { path_traced bounces 30 reflected_luminaires 0 } }
camera { location <0.3, 0.9, -3.3> look_at 0 angle 40 }
sky_sphere { pigment { rgb 1 } luminaire }
sphere { 0, 1 pigment { rgb 1 transmit 0.6 } finish { diffuse 1 } interior { ior 1.5 } }
