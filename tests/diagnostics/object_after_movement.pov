// SPDX-License-Identifier: GPL-3.0-or-later
// An object behind what moves all of them
#version 3.7;
#declare S = sphere { 0, 1 }
union { S translate x S }
