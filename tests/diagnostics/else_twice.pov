// SPDX-License-Identifier: GPL-3.0-or-later
// Two #else
#version 3.7;
#if (0) #else #else #end
