// SPDX-License-Identifier: GPL-3.0-or-later
// Things that are said twice
#version 3.7;
camera { location -z }
camera { location -2*z }
sphere { 0, 1 finish { ambient 0 diffuse 1 ambient 0.2 } }
global_settings { light_sampler { linear_alpha light_octree } }
