// SPDX-License-Identifier: GPL-3.0-or-later
// A value in a union
#version 3.7;
union { sphere { 0, 1 } 3 }
