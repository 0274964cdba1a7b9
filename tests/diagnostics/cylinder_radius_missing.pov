// SPDX-License-Identifier: GPL-3.0-or-later
// The radius of a cylinder
#version 3.7;
cylinder { 0, y }
