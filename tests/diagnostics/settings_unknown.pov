// SPDX-License-Identifier: GPL-3.0-or-later
// A setting that does not exist
#version 3.7;
global_settings { ambient_lights 1 }
