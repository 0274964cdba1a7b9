// SPDX-License-Identifier: GPL-3.0-or-later
// A block misspelt
#version 3.7;
lightsource { y, rgb 1 }
