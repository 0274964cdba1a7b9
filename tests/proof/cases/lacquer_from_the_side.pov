// SPDX-License-Identifier: GPL-3.0-or-later
// law white, seed 1
#version 3.7;
#default { finish { ambient 0 } }
global_settings { assumed_gamma 1 integrator { path_traced bounces 20 } }
background { rgb 1 }
plane { y, 0 pigment { rgb 1 } finish { microfacet { roughness 0.6 coat 1 coat_roughness 0.1 } } }
