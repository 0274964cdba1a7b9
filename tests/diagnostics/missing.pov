// SPDX-License-Identifier: GPL-3.0-or-later
// Words without their values, blocks without what they are for
#version 3.7;
sphere { 0, 1 translate rotate x }
sphere { 0, 1 finish { reflection } }
object { }
sphere { 0, 1 pigment { gradient x color_map { [0 rgb 1] [1] } } }
global_settings { light_sampler { } }
