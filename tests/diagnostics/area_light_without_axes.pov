// SPDX-License-Identifier: GPL-3.0-or-later
// An area light without its axes
#version 3.7;
light_source { 0, rgb 1 area_light 5, 5 }
