// SPDX-License-Identifier: GPL-3.0-or-later
// A macro that comes later in the file
#version 3.7;
M(3)
#macro M(A) A #end
