// SPDX-License-Identifier: GPL-3.0-or-later
// A word of camera misspelt
#version 3.7;
camera { location y lookat 0 }
