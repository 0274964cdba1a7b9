// SPDX-License-Identifier: GPL-3.0-or-later
// A setting out of range
#version 3.7;
global_settings { light_sampler { light_octree { threshold -1 } } }
