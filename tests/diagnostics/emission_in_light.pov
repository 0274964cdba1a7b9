// SPDX-License-Identifier: GPL-3.0-or-later
// emission belongs to an object
#version 3.7;
light_source { y, rgb 1 emission 3 }
