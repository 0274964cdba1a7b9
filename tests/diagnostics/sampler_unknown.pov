// SPDX-License-Identifier: GPL-3.0-or-later
// A light sampler that does not exist
#version 3.7;
global_settings { light_sampler { light_tree } }
