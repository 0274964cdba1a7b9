// SPDX-License-Identifier: GPL-3.0-or-later
// A word of finish misspelt
#version 3.7;
sphere { 0, 1 finish { specualr 0.5 } }
