// SPDX-License-Identifier: GPL-3.0-or-later
// A word of finish outside of it
#version 3.7;
sphere { 0, 1 ambient 1 }
