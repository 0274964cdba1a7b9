// SPDX-License-Identifier: GPL-3.0-or-later
// Values out of their range
#version 3.7;
#declare Gauge = 3;
superellipsoid { <Gauge - 5, 1> }
sphere { 0, 1 finish { roughness 0 } }
global_settings { max_trace_level 1000 }
