// SPDX-License-Identifier: GPL-3.0-or-later
// A union without objects
#version 3.7;
union { }
