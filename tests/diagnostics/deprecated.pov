// SPDX-License-Identifier: GPL-3.0-or-later
// A directive without its sign, as old scenes write it
#version 3.7;
declare Size = 2;
sphere { 0, Size }
